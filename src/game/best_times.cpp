#include "game/best_times.h"

#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "game/whole_file.h"

namespace game {

namespace {

constexpr char times_name[] = "best.json", medals_name[] = "medals.json";

std::optional<std::filesystem::path> file_named(char const* name) {
    auto const folder = data_folder();
    if (!folder) return std::nullopt;
    return *folder / name;
}

struct Listed {
    std::map<std::string, double> numbers;  // by level
    bool spoilt = false;                    // the file holds something that the numbers do not
};

Listed listed_in(char const* name) {
    Listed list;
    auto const file = file_named(name);
    std::error_code missing;
    if (!file || !std::filesystem::is_regular_file(*file, missing)) return list;
    try {
        auto const root = nlohmann::json::parse(read_whole_file(file->string(), 1u << 20));
        list.spoilt = !root.is_object();
        for (auto const& [hash, number] : root.items())
            if (root.is_object() && number.is_number() && std::isfinite(number.get<double>()))
                list.numbers[hash] = number.get<double>();
            else
                list.spoilt = true;
    } catch (std::exception const&) {
        return {{}, true};  // a spoilt list of records must not keep anyone from playing
    }
    return list;
}

// What the file was that was set aside, if it was spoilt.
std::optional<std::filesystem::path> keep(Listed const& list, char const* name, char const* what) {
    auto const file = file_named(name);
    if (!file) throw std::runtime_error(std::string(what) + " cannot be saved: neither XDG_DATA_HOME nor HOME is set");
    std::optional<std::filesystem::path> aside;
    if (list.spoilt) aside = set_aside(*file);
    write_whole_file(file->string(), nlohmann::json(list.numbers).dump(1) + "\n");
    return aside;
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

std::map<std::string, double> best_times() { return listed_in(times_name).numbers; }

std::optional<double> best_time(level::Level const& level) {
    auto const times = best_times();
    auto const found = times.find(level.hash);
    return found == times.end() ? std::nullopt : std::optional<double>(found->second);
}

Noted note_time(level::Level const& level, double seconds) {
    Listed list = listed_in(times_name);
    auto const [place, fresh] = list.numbers.try_emplace(level.hash, seconds);
    if (!fresh && place->second <= seconds) return {Rank::behind, std::nullopt};
    place->second = seconds;
    return {Rank::best, keep(list, times_name, "the best time")};
}

std::map<std::string, Medal> best_medals() {
    std::map<std::string, Medal> medals;
    for (auto const& [hash, number] : listed_in(medals_name).numbers)
        for (Medal const medal : {Medal::bronze, Medal::silver, Medal::gold})
            if (number == static_cast<double>(medal)) medals[hash] = medal;
    return medals;
}

std::optional<std::filesystem::path> note_medal(level::Level const& level, Medal medal) {
    Listed list = listed_in(medals_name);
    double& kept = list.numbers[level.hash];
    if (kept >= static_cast<double>(medal)) return std::nullopt;
    kept = static_cast<double>(medal);
    return keep(list, medals_name, "the medal");
}

}  // namespace game
