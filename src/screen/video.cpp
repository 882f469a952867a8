#include "screen/video.h"

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "screen/child.h"
#include "screen/film.h"

namespace screen {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> encoder(fs::path const& part, std::string const& container, VideoSettings const& settings) {
    std::string const size = std::to_string(settings.width) + "x" + std::to_string(settings.height);
    std::string const rate = std::to_string(settings.rate_numerator) + "/" + std::to_string(settings.rate_denominator);
    // A key frame a second: the file can be cut and played from there, also after a kill.
    int const second = std::max(1, settings.rate_numerator / settings.rate_denominator);
    std::vector<std::string> words{"ffmpeg", "-nostdin", "-hide_banner", "-nostats", "-loglevel", "error", "-y"};
    words.insert(words.end(), {"-progress", "pipe:1"});
    words.insert(words.end(), {"-f", "rawvideo", "-pix_fmt", "yuv420p", "-video_size", size, "-framerate", rate});
    words.insert(words.end(), {"-colorspace", "bt709", "-color_range", "tv", "-i", "pipe:0"});
    if (settings.sound_rate > 0) {
        // Nothing is looked for in the sound before the first frame: it comes along with the frames.
        words.insert(words.end(), {"-f", "f32le", "-ar", std::to_string(settings.sound_rate), "-ac", "2"});
        words.insert(words.end(), {"-probesize", "32", "-analyzeduration", "0", "-i", "pipe:3"});
        words.insert(words.end(), {"-map", "0:v", "-map", "1:a", "-c:a", "aac", "-b:a", "160k"});
    }
    words.insert(words.end(), {"-c:v", "libx264", "-preset", "veryfast", "-crf", std::to_string(settings.quality)});
    words.insert(words.end(), {"-pix_fmt", "yuv420p", "-g", std::to_string(second), "-colorspace", "bt709"});
    words.insert(words.end(), {"-color_primaries", "bt709", "-color_trc", "bt709", "-color_range", "tv"});
    // The header waits for the first fragment: only then is it known by how much picture and sound are to be shifted to
    // begin at once.
    if (container == "mp4") words.insert(words.end(), {"-movflags", "+frag_keyframe+empty_moov+delay_moov"});
    // Each frame on its way to the disk at once: what a killed encoder holds back is lost.
    words.insert(words.end(), {"-flush_packets", "1"});
    words.insert(words.end(), {"-f", container == "mkv" ? "matroska" : container, "file:" + part.string()});
    return words;
}

std::string last_line(std::string text) {
    while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.pop_back();
    auto const start = text.find_last_of("\r\n");
    return start == std::string::npos ? text : text.substr(start + 1);
}

// ffmpeg -progress writes "frame=N" among other lines, over and over.
long long frames_told(std::string const& progress) {
    auto const at = progress.rfind("frame=");
    return at == std::string::npos ? 0 : std::strtoll(progress.c_str() + at + 6, nullptr, 10);
}

std::string words_for(Ending const& ending) {
    if (ending.signal != 0)
        return "was ended by signal " + std::to_string(ending.signal) + " (" + strsignal(ending.signal) + ")";
    return "ended with status " + std::to_string(ending.status);
}

void check(fs::path const& file, VideoSettings const& settings) {
    auto const wrong = [&](std::string const& what) { throw std::runtime_error(file.string() + ": " + what); };
    if (file.extension() != ".mp4" && file.extension() != ".mkv") wrong("a video's name must end in .mp4 or .mkv");
    if (settings.width % 2 != 0 || settings.height % 2 != 0) wrong("a video's width and height must be even");
    if (settings.rate_numerator < 1 || settings.rate_denominator < 1) wrong("a video needs a rate above 0");
    require_paintable(settings.width, settings.height);
}

}  // namespace

fs::path part_name(fs::path const& file) {
    fs::path part = file;
    return part.replace_extension(".part" + file.extension().string());
}

struct Video::Body {
    fs::path file, part;
    VideoSettings settings;
    std::optional<Child> ffmpeg;
    long long frames = 0;

    Body(fs::path file_wanted, VideoSettings const& settings_wanted)
        : file(std::move(file_wanted)), part(part_name(file)), settings(settings_wanted) {
        check(file, settings);
        try {
            ffmpeg.emplace(encoder(part, file.extension().string().substr(1), settings));
        } catch (std::runtime_error const& error) {
            throw std::runtime_error(file.string() + ": " + error.what() + " (Debian's package ffmpeg)");
        }
    }
    ~Body() {
        if (ffmpeg) abandon();
    }

    // Waits for the encoder and throws what went wrong, if anything did.
    void end();
    std::optional<fs::path> abandon();
    // Leaves a part that plays, or none.
    std::optional<fs::path> salvaged() const;
};

std::optional<fs::path> Video::Body::salvaged() const {
    Film const film = film_in(part);
    std::error_code ignored;
    if (film.frames == 0) {
        fs::remove(part, ignored);
        return std::nullopt;
    }
    if (!film.complete) fs::resize_file(part, film.whole_bytes, ignored);
    return part;
}

std::optional<fs::path> Video::Body::abandon() {
    if (ffmpeg) ffmpeg->wait();
    ffmpeg.reset();
    return salvaged();
}

void Video::Body::end() {
    Ending const ending = ffmpeg->wait();
    long long const written = frames_told(ffmpeg->output());
    std::string const said = last_line(ffmpeg->errors());
    ffmpeg.reset();
    Film const film = film_in(part);
    std::string what;
    if (ending.signal != 0 || ending.status != 0)
        what = "ffmpeg " + words_for(ending);
    else if (written != frames)
        what = "ffmpeg wrote " + std::to_string(written) + " of " + std::to_string(frames) + " frames";
    else if (film.frames != frames || !film.complete)
        what = "the file is not whole, with " + std::to_string(film.frames) + " of " + std::to_string(frames) +
               " frames; is the disk full?";
    if (what.empty()) return;
    if (!said.empty()) what += ": " + said;
    auto const left = salvaged();
    throw std::runtime_error(file.string() + ": " + what + (left ? "; what was written is in " + left->string() : ""));
}

Video::Video(fs::path const& file, VideoSettings const& settings) : body_(std::make_unique<Body>(file, settings)) {}
Video::~Video() = default;
Video::Video(Video&&) noexcept = default;
Video& Video::operator=(Video&&) noexcept = default;

void Video::add(Pixels const& pixels) { add(yuv420_of(pixels)); }

void Video::add(Yuv420 const& picture) {
    VideoSettings const& settings = body_->settings;
    if (!body_->ffmpeg) throw std::runtime_error(body_->file.string() + ": the video has ended already");
    if (picture.width != settings.width || picture.height != settings.height)
        throw std::runtime_error(body_->file.string() + ": a frame of another size than the video's");
    if (body_->ffmpeg->feed(picture.bytes)) {
        ++body_->frames;
        return;
    }
    body_->end();
    throw std::runtime_error(body_->file.string() + ": ffmpeg stopped reading after " + std::to_string(body_->frames) +
                             " frames");
}

void Video::add_sound(std::span<float const> samples) {
    if (!body_->ffmpeg) return;
    static_assert(std::endian::native == std::endian::little, "the encoder is told f32le");
    body_->ffmpeg->feed_beside({reinterpret_cast<std::uint8_t const*>(samples.data()), samples.size_bytes()});
}

void Video::finish() {
    if (!body_->ffmpeg) throw std::runtime_error(body_->file.string() + ": the video has ended already");
    body_->end();
    if (std::rename(body_->part.c_str(), body_->file.c_str()) != 0)
        throw std::runtime_error(body_->file.string() + ": " + std::strerror(errno) + "; the video is in " +
                                 body_->part.string());
}

std::optional<fs::path> Video::abandon() { return body_->abandon(); }

long long Video::frames() const { return body_->frames; }

}  // namespace screen
