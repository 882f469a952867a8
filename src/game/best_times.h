// The best time of every level, kept in the user's data folder between games.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "level/level.h"

namespace game {

// $XDG_DATA_HOME/smb2d, else ~/.local/share/smb2d; nothing where neither is known. It need not exist.
std::optional<std::filesystem::path> data_folder();

// Seconds by the level's hash. What is missing or cannot be read counts as no times yet.
std::map<std::string, double> best_times();

std::optional<double> best_time(level::Level const& level);

enum class Rank { best, behind };
// Saves the time if the level had none or a longer one. Throws std::runtime_error where it cannot be saved.
Rank note_time(level::Level const& level, double seconds);

}  // namespace game
