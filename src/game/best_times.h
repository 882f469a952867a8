// The best time and medal of every level, kept in the user's data folder between games.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "game/medals.h"
#include "level/level.h"

namespace game {

// Seconds by the level's hash. What is missing or cannot be read counts as no times yet.
std::map<std::string, double> best_times();

std::optional<double> best_time(level::Level const& level);

enum class Rank { best, behind };
struct Noted {
    Rank rank = Rank::behind;
    std::optional<std::filesystem::path> set_aside;  // what the list that was there is called now, if it was spoilt
};
// Saves the time if the level had none or a longer one. A list that cannot be read to its end is set aside before.
// Throws std::runtime_error where it cannot be saved.
Noted note_time(level::Level const& level, double seconds);

// The same for medals.
std::map<std::string, Medal> best_medals();
std::optional<std::filesystem::path> note_medal(level::Level const& level, Medal medal);  // what was set aside

}  // namespace game
