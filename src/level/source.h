// A level file as bytes and as text: opening it, unpacking it, and the line that an offset lies on.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace level {

inline constexpr std::size_t largest_file = 64'000'000;  // bytes, docs/levels.md

// Stops reading beyond largest_file. Throws std::runtime_error("file: cannot be read: why").
std::string bytes_of(std::string const& file);

// What a file packed with gzip (.svgz) holds; other bytes as they are. Stops unpacking beyond largest_file. Throws
// Broken where the packing is damaged.
std::string unpacked(std::string bytes);

class Lines {
public:
    explicit Lines(std::string const& text);
    int line_at(std::ptrdiff_t offset) const;  // from 1; an offset outside the text counts as its nearer end

private:
    std::vector<std::ptrdiff_t> ends_;  // offsets of the line feeds
};

}  // namespace level
