#include "game/best_times.h"

#include <cmath>
#include <exception>

#include <nlohmann/json.hpp>

#include "game/data_files.h"

namespace game {

namespace {

constexpr char times_name[] = "best.json", medals_name[] = "medals.json";

struct Listed {
    std::map<std::string, double> numbers;  // by level
    bool spoilt = false;                    // the file holds something that the numbers do not
};

Listed listed_in(char const* name) {
    Listed list;
    try {
        auto const root = read_data_file(name);
        if (!root) return list;
        list.spoilt = !root->is_object();
        for (auto const& [hash, number] : root->items())
            if (root->is_object() && number.is_number() && std::isfinite(number.get<double>()))
                list.numbers[hash] = number.get<double>();
            else
                list.spoilt = true;
    } catch (std::exception const&) {
        return {{}, true};  // a spoilt list of records must not keep anyone from playing
    }
    return list;
}

// What the file was that was set aside, if it was spoilt.
std::optional<std::filesystem::path> keep(Listed const& list, char const* name, char const* failure) {
    return write_data_file(name, list.numbers, 1, list.spoilt, failure);
}

}  // namespace

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
    return {Rank::best, keep(list, times_name, "the best time cannot be saved")};
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
    return keep(list, medals_name, "the medal cannot be saved");
}

}  // namespace game
