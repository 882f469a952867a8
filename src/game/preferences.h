// What the player prefers, kept in the user's data folder between games.
#pragma once

#include <filesystem>
#include <optional>

namespace game {

struct Preferences {
    double volume = 0.8;  // of the sound, in [0, 1]
    bool muted = false;
    bool operator==(Preferences const&) const = default;
};

// What is missing, or cannot be read, is as above.
Preferences preferences();

// What was there before is called otherwise, if it was spoilt: then its new name. Throws std::runtime_error where it
// cannot be saved.
std::optional<std::filesystem::path> keep(Preferences const& preferences);

}  // namespace game
