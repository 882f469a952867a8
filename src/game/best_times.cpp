#include "game/best_times.h"

#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "game/whole_file.h"

namespace game {

namespace {

std::optional<std::filesystem::path> best_file() {
    auto const folder = data_folder();
    if (!folder) return std::nullopt;
    return *folder / "best.json";
}

struct Listed {
    std::map<std::string, double> times;
    bool spoilt = false;  // the file holds something that the times do not
};

Listed listed() {
    Listed list;
    auto const file = best_file();
    std::error_code missing;
    if (!file || !std::filesystem::is_regular_file(*file, missing)) return list;
    try {
        auto const root = nlohmann::json::parse(read_whole_file(file->string(), 1u << 20));
        list.spoilt = !root.is_object();
        for (auto const& [hash, seconds] : root.items())
            if (root.is_object() && seconds.is_number() && std::isfinite(seconds.get<double>()))
                list.times[hash] = seconds.get<double>();
            else
                list.spoilt = true;
    } catch (std::exception const&) {
        return {{}, true};  // a spoilt list of records must not keep anyone from playing
    }
    return list;
}

}  // namespace

std::optional<std::filesystem::path> data_folder() {
    // A relative path there is to be ignored, says the XDG base directory specification.
    char const* const data = std::getenv("XDG_DATA_HOME");
    if (data && data[0] == '/') return std::filesystem::path(data) / "smb2d";
    char const* const home = std::getenv("HOME");
    if (home && home[0] == '/') return std::filesystem::path(home) / ".local/share/smb2d";
    return std::nullopt;
}

std::map<std::string, double> best_times() { return listed().times; }

std::optional<double> best_time(level::Level const& level) {
    auto const times = best_times();
    auto const found = times.find(level.hash);
    return found == times.end() ? std::nullopt : std::optional<double>(found->second);
}

Noted note_time(level::Level const& level, double seconds) {
    Listed list = listed();
    auto const [place, fresh] = list.times.try_emplace(level.hash, seconds);
    if (!fresh && place->second <= seconds) return {Rank::behind, std::nullopt};
    place->second = seconds;
    auto const file = best_file();
    if (!file) throw std::runtime_error("the best time cannot be saved: neither XDG_DATA_HOME nor HOME is set");
    Noted noted{Rank::best, std::nullopt};
    if (list.spoilt) noted.set_aside = set_aside(*file);
    write_whole_file(file->string(), nlohmann::json(list.times).dump(1) + "\n");
    return noted;
}

}  // namespace game
