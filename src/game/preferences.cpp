#include "game/preferences.h"

#include <algorithm>
#include <exception>

#include <nlohmann/json.hpp>

#include "game/data_files.h"

namespace game {

namespace {

constexpr char const *preferences_name = "preferences.json", *volume_key = "volume", *muted_key = "muted",
                     *turning_key = "turning", *motion_key = "reduced_motion", *contrast_key = "high_contrast",
                     *language_key = "language", *keys_key = "keys";

struct LanguageName {
    std::optional<Language> language;
    char const* name;
};
constexpr LanguageName language_names[] = {
    {std::nullopt, "system"}, {Language::english, "english"}, {Language::german, "german"}};

// What the file holds, an object; spoilt where it is there but holds none.
struct FileContent {
    nlohmann::json root = nlohmann::json::object();
    bool spoilt = false;
};

FileContent file_content() {
    try {
        auto root = read_data_file(preferences_name);
        if (!root) return {};
        if (root->is_object()) return {std::move(*root), false};
    } catch (std::exception const&) {
        // Told by being spoilt.
    }
    return {nlohmann::json::object(), true};
}

void read_flag(nlohmann::json const& root, char const* key, bool& flag, std::vector<std::string>& faults) {
    auto const found = root.find(key);
    if (found == root.end()) return;
    if (found->is_boolean())
        flag = found->get<bool>();
    else
        faults.push_back(std::string(key) + ": must be true or false, got " + found->dump());
}

void read_volume(nlohmann::json const& root, double& volume, std::vector<std::string>& faults) {
    auto const found = root.find(volume_key);
    if (found == root.end()) return;
    double const value = found->is_number() ? found->get<double>() : -1;
    if (value >= 0 && value <= 1)
        volume = value;
    else
        faults.push_back(std::string(volume_key) + ": must be a number from 0 to 1, got " + found->dump());
}

void read_language(nlohmann::json const& root, std::optional<Language>& language, std::vector<std::string>& faults) {
    auto const found = root.find(language_key);
    if (found == root.end()) return;
    for (LanguageName const& entry : language_names)
        if (*found == entry.name) {
            language = entry.language;
            return;
        }
    faults.push_back(std::string(language_key) + ": must be system, english or german, got " + found->dump());
}

void read_keys(nlohmann::json const& root, ChosenKeys& keys, std::vector<std::string>& faults) {
    auto const found = root.find(keys_key);
    if (found == root.end()) return;
    if (!found->is_object()) return faults.push_back(std::string(keys_key) + ": must be an object");
    for (auto const& [action, list] : found->items()) {
        bool const is_list =
            list.is_array() && std::all_of(list.begin(), list.end(), [](auto const& key) { return key.is_string(); });
        if (list.is_string())
            keys[action] = {list.template get<std::string>()};
        else if (is_list)
            keys[action] = list.template get<std::vector<std::string>>();
        else
            faults.push_back(std::string(keys_key) + ": " + action + ": must be a list of names of keys");
    }
}

char const* name_of(std::optional<Language> const& language) {
    for (LanguageName const& entry : language_names)
        if (entry.language == language) return entry.name;
    return language_names[0].name;
}

}  // namespace

ReadPreferences read_preferences() {
    ReadPreferences read;
    auto const folder = data_folder();
    if (!folder) return read;
    read.file = (*folder / preferences_name).string();
    FileContent const content = file_content();
    if (content.spoilt) read.faults.push_back("cannot be read as JSON; nothing in it counts");
    read_volume(content.root, read.preferences.volume, read.faults);
    read_flag(content.root, muted_key, read.preferences.muted, read.faults);
    read_flag(content.root, turning_key, read.preferences.turning, read.faults);
    read_flag(content.root, motion_key, read.preferences.reduced_motion, read.faults);
    read_flag(content.root, contrast_key, read.preferences.high_contrast, read.faults);
    read_language(content.root, read.preferences.language, read.faults);
    read_keys(content.root, read.preferences.keys, read.faults);
    return read;
}

std::optional<std::filesystem::path> keep(Preferences const& preferences) {
    FileContent content = file_content();
    nlohmann::json& root = content.root;
    root[volume_key] = preferences.volume;
    root[muted_key] = preferences.muted;
    root[turning_key] = preferences.turning;
    root[motion_key] = preferences.reduced_motion;
    root[contrast_key] = preferences.high_contrast;
    root[language_key] = name_of(preferences.language);
    root[keys_key] = preferences.keys;
    return write_data_file(preferences_name, root, 1, content.spoilt, "preferences cannot be kept");
}

}  // namespace game
