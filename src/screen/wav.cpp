#include "screen/wav.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "screen/video.h"

namespace screen {
namespace {

constexpr std::uint32_t header_bytes = 44, wav_sides = 2, bytes_a_number = 2;

void add_little_endian(std::string& bytes, std::uint32_t number, int count) {
    for (int i = 0; i < count; ++i) bytes += static_cast<char>(number >> 8 * i & 0xff);
}

// Microsoft and IBM, "Multimedia Programming Interface and Data Specifications 1.0", 1991: RIFF WAVE, PCM.
std::string header_for(int rate, std::uint32_t data_bytes) {
    std::string header = "RIFF";
    add_little_endian(header, data_bytes + header_bytes - 8, 4);
    header += "WAVEfmt ";
    add_little_endian(header, 16, 4);
    add_little_endian(header, 1, 2);  // PCM
    add_little_endian(header, wav_sides, 2);
    add_little_endian(header, static_cast<std::uint32_t>(rate), 4);
    add_little_endian(header, static_cast<std::uint32_t>(rate) * wav_sides * bytes_a_number, 4);
    add_little_endian(header, wav_sides * bytes_a_number, 2);
    add_little_endian(header, 8 * bytes_a_number, 2);
    header += "data";
    add_little_endian(header, data_bytes, 4);
    return header;
}

}  // namespace

Wav::Wav(std::filesystem::path const& file, int rate) : file_(file), part_(part_name(file)), rate_(rate) {
    descriptor_ = open(part_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (descriptor_ < 0) throw std::runtime_error(part_.string() + ": " + std::strerror(errno));
    try {
        write_header();
    } catch (std::runtime_error const&) {
        abandon();
        throw;
    }
}

Wav::~Wav() { abandon(); }

void Wav::write(void const* bytes, std::size_t count) {
    if (descriptor_ < 0) throw std::runtime_error(file_.string() + ": the sound has ended already");
    auto const* at = static_cast<char const*>(bytes);
    while (count > 0) {
        ssize_t const written = ::write(descriptor_, at, count);
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) throw std::runtime_error(file_.string() + ": " + std::strerror(errno));
        at += written;
        count -= static_cast<std::size_t>(written);
    }
}

void Wav::write_header() {
    std::string const header = header_for(rate_, data_bytes_);
    write(header.data(), header.size());
}

void Wav::add(std::span<float const> samples) {
    std::string bytes;
    for (float const sample : samples) {
        long const number = std::lround(std::clamp(sample, -1.0f, 1.0f) * 32767);
        add_little_endian(bytes, static_cast<std::uint32_t>(number), bytes_a_number);
    }
    write(bytes.data(), bytes.size());
    data_bytes_ += static_cast<std::uint32_t>(bytes.size());
}

void Wav::finish() {
    if (descriptor_ < 0 || lseek(descriptor_, 0, SEEK_SET) < 0)
        throw std::runtime_error(file_.string() + ": the sound cannot be ended");
    write_header();
    if (close(std::exchange(descriptor_, -1)) != 0 || std::rename(part_.c_str(), file_.c_str()) != 0)
        throw std::runtime_error(file_.string() + ": " + std::strerror(errno) + "; the sound is in " + part_.string());
}

std::optional<std::filesystem::path> Wav::abandon() {
    if (descriptor_ < 0) return std::nullopt;
    // What a full disk let through of the last samples is not counted, and harms nobody.
    std::string const header = header_for(rate_, data_bytes_);
    bool const told = pwrite(descriptor_, header.data(), header.size(), 0) == static_cast<ssize_t>(header.size());
    close(std::exchange(descriptor_, -1));
    if (told && data_bytes_ > 0) return part_;
    std::error_code ignored;
    std::filesystem::remove(part_, ignored);
    return std::nullopt;
}

}  // namespace screen
