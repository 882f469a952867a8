// smb2d record: a film with its sound, or the sound alone, without a display.
#include <algorithm>
#include <climits>
#include <cmath>
#include <deque>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>

#include "app/command.h"
#include "app/interrupt.h"
#include "app/output.h"
#include "app/progress.h"
#include "app/sequence.h"
#include "app/soundtrack.h"
#include "screen/video.h"
#include "screen/wav.h"

namespace app {

namespace {

int even(int side) { return side + side % 2; }

struct RecordOptions {
    SequenceOptions sequence;
    bool no_sound = false;
};

enum class Container { film, sound };
Container container_of(RecordOptions const& options) {
    std::string const& file = options.sequence.output;
    std::string const ending = std::filesystem::path(file).extension().string();
    if (ending == ".wav" && options.no_sound) throw UsageError("--no-sound leaves nothing to write into a .wav file");
    if (ending == ".wav") return Container::sound;
    if (ending == ".mp4" || ending == ".mkv") return Container::film;
    throw UsageError("--output must end in .mp4, .mkv or .wav, got \"" + file + "\"");
}

void make_way_for(std::filesystem::path const& file, bool overwrite) {
    std::error_code error;
    if (!overwrite && std::filesystem::exists(std::filesystem::symlink_status(file, error)))
        throw std::runtime_error(file.string() + ": is there already; --overwrite replaces it");
    if (!file.has_parent_path()) return;
    std::filesystem::create_directories(file.parent_path(), error);
    if (error) throw std::runtime_error(file.parent_path().string() + ": " + error.message());
}

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

double time_of(Sequence const& sequence, long long frame) {
    return game::frame_time(sequence.from, frame, sequence.rate);
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
FrameJob craft_for(screen::Video& video, Sequence& sequence, FrameSounds* sounds) {
    FrameJob job;
    job.make = [](long long, screen::Pixels const& pixels) { return screen::yuv420_of(pixels).bytes; };
    job.deliver = [&video, size = sequence.size, sounds](std::vector<std::uint8_t> bytes) {
        if (sounds) video.add_sound(sounds->next());
        video.add(screen::Yuv420{size.width, size.height, std::move(bytes)});
    };
    if (sounds) job.order = [&sequence, sounds](long long frame) { sounds->make(sequence, frame); };
    return job;
}

// What was recorded before a failure is named, unless the failure names it already.
template <typename Recording>
std::string with_part(std::string const& what, Recording& recording) {
    auto const part = recording.abandon();
    if (!part || what.find(part->string()) != std::string::npos) return what;
    return what + "; what was recorded until then is in " + part->string();
}

// Runs `work` to its end, else says what of the recording is left.
template <typename Recording, typename Work>
void keep_what_is_left(Recording& recording, Work work) {
    try {
        work();
        recording.finish();
    } catch (Interrupted const& interruption) {
        throw Interrupted(with_part(interruption.what(), recording));
    } catch (std::runtime_error const& error) {
        throw std::runtime_error(with_part(error.what(), recording));
    }
}

void record_film(Sequence& sequence, RecordOptions const& options) {
    round_up(sequence.size, options.sequence);
    screen::VideoSettings settings = settings_for(sequence);
    settings.sound_rate = options.no_sound ? 0 : sound::rate;
    make_way_for(options.sequence.output, options.sequence.overwrite);
    screen::Video video(options.sequence.output, settings);
    keep_what_is_left(video, [&] {
        std::optional<FrameSounds> sounds;
        if (!options.no_sound) sounds.emplace(sequence);
        make_frames(sequence, craft_for(video, sequence, sounds ? &*sounds : nullptr));
    });
}

// As long as the film of the same options.
void record_sound(Sequence& sequence, RecordOptions const& options) {
    double const seconds = time_of(sequence, sequence.count) - sequence.from.value();
    if (seconds * sound::rate > screen::most_wav_samples)
        throw UsageError("a .wav file holds at most " + std::to_string(screen::most_wav_samples / sound::rate) + " s");
    make_way_for(options.sequence.output, options.sequence.overwrite);
    screen::Wav wav(options.sequence.output, sound::rate);
    keep_what_is_left(wav, [&] {
        Progress progress(sequence.count, sequence.quiet ? Progress::Bar::never : Progress::Bar::on_terminal);
        Soundtrack soundtrack(sequence.session, sequence.from.value());
        for (long long frame = 1; frame <= sequence.count; ++frame) {
            wav.add(soundtrack.on_to(sequence.session, time_of(sequence, frame)));
            progress.show(frame);
        }
    });
}

int record(RecordOptions const& options) {
    Container const container = container_of(options);
    Sequence sequence = sequence_for(options.sequence);
    if (container == Container::film)
        record_film(sequence, options);
    else
        record_sound(sequence, options);
    expect_tolerance_kept(options.sequence.file, sequence.session);
    return done;
}

}  // namespace

Command record_command(CommandLine& program) {
    auto const options = std::make_shared<RecordOptions>();
    Subcommand command = program.add("record", "A film with its sound, no display needed");
    declare(command, options->sequence);
    command.needs("-o,--output", options->sequence.output, "demo.mp4, demo.mkv, or demo.wav for the sound alone", "FILE");
    command.takes_flag("--no-sound", options->no_sound, "a silent film");
    command.ends_help_with("Example: smb2d record assets/levels/01-sunny-hills.svg -o demo.mp4 --to 5");
    return {command, [options] { return record(*options); }};
}

}  // namespace app
