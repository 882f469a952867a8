// What the player prefers, kept in the user's data folder between games.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "game/actions.h"
#include "game/texts.h"

namespace game {

struct Preferences {
    double volume = 0.8;  // of the sound, in [0, 1]
    bool muted = false;
    bool turning = true;  // of the picture, as the stage is tilted
    bool reduced_motion = false;
    bool high_contrast = false;
    std::optional<Language> language;  // nothing = the system's
    ChosenKeys keys;                   // of actions whose keys are not as they came
    bool operator==(Preferences const&) const = default;
};

inline Language language_of(Preferences const& preferences) {
    return preferences.language ? *preferences.language : language_of_system();
}

// What is missing, or cannot be read, is as above; what cannot be read is told.
struct ReadPreferences {
    Preferences preferences;
    std::string file;                 // empty where there is no folder for it
    std::vector<std::string> faults;  // what of the file, a line each
};
ReadPreferences read_preferences();

// What the file holds beside them stays. What was there before is called otherwise, if it was spoilt: then its new
// name. Throws std::runtime_error where it cannot be saved.
std::optional<std::filesystem::path> keep(Preferences const& preferences);

}  // namespace game
