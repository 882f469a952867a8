// Films on disk: what of a file of fragments is whole, found by walking its container, whatever an encoder says.
#pragma once

#include <cstdint>
#include <filesystem>

namespace screen {

struct Film {
    long long frames = 0;           // of the first track, in fragments that are there to their last byte
    std::uint64_t whole_bytes = 0;  // up to the end of the last of them: cut there, the film plays without complaint
    bool complete = false;          // and the container is closed, with its index, where the file ends
};

// Of a fragmented MP4 (ISO/IEC 14496-12, 8.8) or a Matroska file (RFC 9559), by the name's ending. Reads headers alone:
// some ten bytes a fragment of the former, a frame of the latter. What cannot be read has no frames.
Film film_in(std::filesystem::path const& file);

}  // namespace screen
