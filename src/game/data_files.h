// Small files of JSON in the user's data folder: what is kept between games.
#pragma once

#include <filesystem>
#include <optional>

#include <nlohmann/json_fwd.hpp>

namespace game {

// $XDG_DATA_HOME/smb2d, else ~/.local/share/smb2d; nothing where neither is known. It need not exist.
std::optional<std::filesystem::path> data_folder();

// What the file of this name holds; nothing where there is none. Throws std::exception where it cannot be read or is no
// JSON.
std::optional<nlohmann::json> read_data_file(char const* name);

// Writes it whole. One that was `spoilt` is set aside before: then its new name is returned. Throws
// std::runtime_error; `failure` is what is said where there is no folder, such as "the best time cannot be saved".
std::optional<std::filesystem::path> write_data_file(char const* name, nlohmann::json const& root, int indent,
                                                     bool spoilt, char const* failure);

}  // namespace game
