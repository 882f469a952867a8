#include "game/preferences.h"

#include <stdexcept>
#include <string>

#include <nlohmann/json.hpp>

#include "game/best_times.h"
#include "game/whole_file.h"

namespace game {

namespace {

constexpr char const *volume_key = "volume", *muted_key = "muted";

std::optional<std::filesystem::path> preferences_file() {
    auto const folder = data_folder();
    if (!folder) return std::nullopt;
    return *folder / "preferences.json";
}

struct ReadPreferences {
    Preferences preferences;
    bool spoilt = false;  // the file is there, but is not ours
};

ReadPreferences read_preferences() {
    ReadPreferences result;
    auto const file = preferences_file();
    std::error_code missing;
    if (!file || !std::filesystem::is_regular_file(*file, missing)) return result;
    try {
        auto const root = nlohmann::json::parse(read_whole_file(file->string(), 1u << 16));
        result.spoilt = !root.is_object();
        if (result.spoilt) return result;
        double const volume = root.value(volume_key, Preferences{}.volume);
        if (volume >= 0 && volume <= 1) result.preferences.volume = volume;
        result.preferences.muted = root.value(muted_key, Preferences{}.muted);
    } catch (std::exception const&) {
        result.spoilt = true;
    }
    return result;
}

}  // namespace

Preferences preferences() { return read_preferences().preferences; }

std::optional<std::filesystem::path> keep(Preferences const& preferences) {
    auto const file = preferences_file();
    if (!file) throw std::runtime_error("preferences cannot be kept: neither XDG_DATA_HOME nor HOME is set");
    std::optional<std::filesystem::path> aside;
    if (read_preferences().spoilt) aside = set_aside(*file);
    nlohmann::json const root{{volume_key, preferences.volume}, {muted_key, preferences.muted}};
    write_whole_file(file->string(), root.dump(1) + "\n");
    return aside;
}

}  // namespace game
