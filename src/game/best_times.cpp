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

}  // namespace

std::optional<std::filesystem::path> data_folder() {
    // A relative path there is to be ignored, says the XDG base directory specification.
    char const* const data = std::getenv("XDG_DATA_HOME");
    if (data && data[0] == '/') return std::filesystem::path(data) / "smb2d";
    char const* const home = std::getenv("HOME");
    if (home && home[0] == '/') return std::filesystem::path(home) / ".local/share/smb2d";
    return std::nullopt;
}

std::map<std::string, double> best_times() {
    std::map<std::string, double> times;
    auto const file = best_file();
    std::error_code missing;
    if (!file || !std::filesystem::is_regular_file(*file, missing)) return times;
    try {
        auto const root = nlohmann::json::parse(read_whole_file(file->string(), 1u << 20));
        for (auto const& [hash, seconds] : root.items())
            if (seconds.is_number() && std::isfinite(seconds.get<double>())) times[hash] = seconds.get<double>();
    } catch (std::exception const&) {
        times.clear();  // a spoilt list of records must not keep anyone from playing
    }
    return times;
}

std::optional<double> best_time(level::Level const& level) {
    auto const times = best_times();
    auto const found = times.find(level.hash);
    return found == times.end() ? std::nullopt : std::optional<double>(found->second);
}

Rank note_time(level::Level const& level, double seconds) {
    auto times = best_times();
    auto const [place, fresh] = times.try_emplace(level.hash, seconds);
    if (!fresh && place->second <= seconds) return Rank::behind;
    place->second = seconds;
    auto const file = best_file();
    if (!file) throw std::runtime_error("the best time cannot be saved: neither XDG_DATA_HOME nor HOME is set");
    write_whole_file(file->string(), nlohmann::json(times).dump(1) + "\n");
    return Rank::best;
}

}  // namespace game
