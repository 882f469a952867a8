// Sound files: 16 bits, two sides, as RIFF WAVE.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>

namespace screen {

// The most samples of two sides that the format's 32-bit sizes can tell.
inline constexpr long long most_wav_samples = (0xffffffffLL - 36) / 4;

// Samples go to part_name(file), which `finish` renames. Every failure is a std::runtime_error that names the file.
class Wav {
public:
    // `rate` samples a second.
    Wav(std::filesystem::path const& file, int rate);
    ~Wav();  // abandons it, unless it has ended
    Wav(Wav const&) = delete;
    Wav& operator=(Wav const&) = delete;

    // Both sides in turn, left first; what is beyond [-1, 1] counts as its end.
    void add(std::span<float const> samples);
    // Writes how long it is, and renames.
    void finish();
    // Leaves a part that plays as far as it goes, and returns its name, or leaves nothing.
    std::optional<std::filesystem::path> abandon();

private:
    void write(void const* bytes, std::size_t count);
    void write_header();

    std::filesystem::path file_, part_;
    int rate_;
    int descriptor_ = -1;
    std::uint32_t data_bytes_ = 0;
};

}  // namespace screen
