// Files that are either whole or not there: written beside their name and renamed when they are complete.
#pragma once

#include <string>
#include <string_view>

namespace game {

// Makes the folder when it is missing. On failure throws std::runtime_error("file: why"); what bore the name before
// is then still there and nothing is left beside it.
void write_whole_file(std::string const& file, std::string_view bytes);

// Throws std::runtime_error("file: why"); a file over `limit` bytes is refused.
std::string read_whole_file(std::string const& file, std::size_t limit);

}  // namespace game
