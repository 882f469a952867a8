// Video files: a pipe to the program ffmpeg, which must be installed.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>

#include "screen/pixels.h"

namespace screen {

struct VideoSettings {
    int width = 1280, height = 720;                 // pixels, both even
    int rate_numerator = 60, rate_denominator = 1;  // frames a second
    int quality = 18;                               // x264's constant rate factor: lower is better and larger
    int sound_rate = 0;                             // samples a second, of both sides; 0 = a silent film
};

// Pictures that an encoder takes: luma, then the two chroma planes at half the size (BT.709, limited range).
struct Yuv420 {
    int width = 0, height = 0;  // pixels, both even
    std::vector<std::uint8_t> bytes;
};
Yuv420 yuv420_of(Pixels const& pixels);

// The name that a video bears until it is whole: demo.part.mp4.
std::filesystem::path part_name(std::filesystem::path const& file);

// Frames go to part_name(file), which plays as far as it goes at any moment; `finish` renames it.
// Every failure is a std::runtime_error that names the file and, if it holds frames, the part.
class Video {
public:
    // The ending of the name chooses the container: .mp4 or .mkv.
    Video(std::filesystem::path const& file, VideoSettings const& settings);
    ~Video();  // abandons it, unless it has ended
    Video(Video&&) noexcept;
    Video& operator=(Video&&) noexcept;

    void add(Pixels const& pixels);
    // Of pictures converted before, for instance on other threads.
    void add(Yuv420 const& picture);
    // Samples of both sides in turn, in [-1, 1]: those that are heard from the next frame on until the one after it,
    // before that frame is added. What the encoder no longer takes is told when a frame is added.
    void add_sound(std::span<float const> samples);
    // Waits for the encoder, checks that the file holds every frame and is whole, whatever the encoder says, renames.
    void finish();
    // Lets the encoder close the part. What of it plays, if any: what does not is cut off or removed.
    std::optional<std::filesystem::path> abandon();

    long long frames() const;  // given to the encoder so far

private:
    struct Body;
    std::unique_ptr<Body> body_;
};

}  // namespace screen
