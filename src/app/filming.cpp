#include "app/filming.h"

#include <climits>
#include <cmath>
#include <deque>
#include <mutex>
#include <optional>

#include "app/command.h"
#include "app/output.h"
#include "app/soundtrack.h"
#include "screen/video.h"

namespace app {

namespace {

int even(int side) { return side + side % 2; }

void round_up(Size& size, SequenceOptions const& options) {
    Size const rounded{even(size.width), even(size.height)};
    if (!options.quiet && (rounded.width != size.width || rounded.height != size.height))
        note("smb2d: video needs even sizes: " + std::to_string(rounded.width) + "x" + std::to_string(rounded.height));
    size = rounded;
}

screen::VideoSettings settings_for(Sequence const& sequence) {
    bool const is_whole = std::floor(sequence.rate.numerator) == sequence.rate.numerator;
    if (!is_whole || sequence.rate.numerator > INT_MAX || sequence.rate.denominator > INT_MAX)
        throw UsageError("--fps has too many digits for a video");
    screen::VideoSettings settings;
    settings.width = sequence.size.width;
    settings.height = sequence.size.height;
    settings.rate_numerator = static_cast<int>(sequence.rate.numerator);
    settings.rate_denominator = static_cast<int>(sequence.rate.denominator);
    return settings;
}

// The sound of every frame, worked out when the frame is ordered, fetched when it is delivered, on another thread.
class FrameSounds {
public:
    explicit FrameSounds(Sequence& sequence) : soundtrack_(sequence.session, sequence.from.value()) {}

    void make(Sequence& sequence, long long frame) {
        bool const is_last = frame + 1 == sequence.count;
        // Beyond the last frame the game is heard, but not held to a tolerance.
        game::Session beyond;
        if (is_last) beyond = sequence.session;
        beyond.watch.reset();
        auto samples = soundtrack_.on_to(is_last ? beyond : sequence.session, time_of(sequence, frame + 1));
        std::scoped_lock const lock(mutex_);
        waiting_.push_back(std::move(samples));
    }
    std::vector<float> next() {
        std::scoped_lock const lock(mutex_);
        std::vector<float> samples = std::move(waiting_.front());
        waiting_.pop_front();
        return samples;
    }

private:
    Soundtrack soundtrack_;
    std::mutex mutex_;
    std::deque<std::vector<float>> waiting_;  // by frame, those that are being painted
};

// `sounds` may be missing.
FrameJob craft_for(screen::Video& video, Sequence const& sequence, FrameSounds* sounds) {
    FrameJob job;
    job.make = [](long long, screen::Pixels const& pixels) { return screen::yuv420_of(pixels).bytes; };
    job.deliver = [&video, size = sequence.size, sounds](std::vector<std::uint8_t> bytes) {
        if (sounds) video.add_sound(sounds->next());
        video.add(screen::Yuv420{size.width, size.height, std::move(bytes)});
    };
    return job;
}

}  // namespace

void make_way_for(std::filesystem::path const& file, bool overwrite) {
    std::error_code error;
    if (!overwrite && std::filesystem::exists(std::filesystem::symlink_status(file, error)))
        throw std::runtime_error(file.string() + ": is there already; --overwrite replaces it");
    if (!file.has_parent_path()) return;
    std::filesystem::create_directories(file.parent_path(), error);
    if (error) throw std::runtime_error(file.parent_path().string() + ": " + error.message());
}

void write_film(Sequence& sequence, FilmOptions const& options) {
    round_up(sequence.size, options.sequence);
    screen::VideoSettings settings = settings_for(sequence);
    settings.sound_rate = options.no_sound ? 0 : sound::rate;
    make_way_for(options.sequence.output, options.sequence.overwrite);
    screen::Video video(options.sequence.output, settings);
    keep_what_is_left(video, [&] {
        std::optional<FrameSounds> sounds;
        if (!options.no_sound) sounds.emplace(sequence);
        FrameJob job = craft_for(video, sequence, sounds ? &*sounds : nullptr);
        job.order = [&](long long frame) {
            if (options.told) options.told(frame);
            if (sounds) sounds->make(sequence, frame);
        };
        make_frames(sequence, job);
    });
}

}  // namespace app
