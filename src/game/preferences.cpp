#include "game/preferences.h"

#include <exception>

#include <nlohmann/json.hpp>

#include "game/data_files.h"

namespace game {

namespace {

constexpr char const *preferences_name = "preferences.json", *volume_key = "volume", *muted_key = "muted";

struct ReadPreferences {
    Preferences preferences;
    bool spoilt = false;  // the file is there, but is not ours
};

ReadPreferences read_preferences() {
    ReadPreferences result;
    try {
        auto const root = read_data_file(preferences_name);
        if (!root) return result;
        result.spoilt = !root->is_object();
        if (result.spoilt) return result;
        double const volume = root->value(volume_key, Preferences{}.volume);
        if (volume >= 0 && volume <= 1) result.preferences.volume = volume;
        result.preferences.muted = root->value(muted_key, Preferences{}.muted);
    } catch (std::exception const&) {
        result.spoilt = true;
    }
    return result;
}

}  // namespace

Preferences preferences() { return read_preferences().preferences; }

std::optional<std::filesystem::path> keep(Preferences const& preferences) {
    nlohmann::json const root{{volume_key, preferences.volume}, {muted_key, preferences.muted}};
    return write_data_file(preferences_name, root, 1, read_preferences().spoilt, "preferences cannot be kept");
}

}  // namespace game
