// Files that are either whole or not there: written beside their name and renamed when they are complete.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace game {

// The file that a name leads to: where it is a link, what that points at, be it there or not. Throws
// std::runtime_error for links without end.
std::string behind_links(std::string const& file);

// Makes the folder when it is missing. A link stays one: what it points at is written. On failure throws
// std::runtime_error("file: why"); what bore the name before is then still there and nothing is left beside it.
void write_whole_file(std::string const& file, std::string_view bytes);

// Throws std::runtime_error("file: why"); a file over `limit` bytes is refused.
std::string read_whole_file(std::string const& file, std::size_t limit);

// Gives a file that is spoilt another name that is free, and returns it; a link stays where it is.
std::filesystem::path set_aside(std::filesystem::path const& file);

}  // namespace game
