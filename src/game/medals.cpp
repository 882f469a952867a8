#include "game/medals.h"

#include <algorithm>

namespace game {

int bananas_in(level::Level const& level) {
    return static_cast<int>(std::count(level.meanings.begin(), level.meanings.end(), level::Meaning::banana));
}

Marks marks_of(level::Level const& level, Status const& status) {
    auto const met = [](bool asked, bool is_so) { return !asked ? Met::not_asked : is_so ? Met::yes : Met::no; };
    Marks marks;
    auto const& pars = level.pars;
    marks.time = met(pars.time.has_value(), status.goal_time && pars.time && *status.goal_time <= *pars.time);
    marks.pulls = met(pars.pulls.has_value(), pars.pulls && status.pulls <= *pars.pulls);
    marks.bananas = met(bananas_in(level) > 0, status.bananas == bananas_in(level));
    return marks;
}

Medal medal_for(level::Level const& level, Status const& status) {
    if (!status.goal_time) return Medal::none;
    Marks const marks = marks_of(level, status);
    Met const all[] = {marks.time, marks.pulls, marks.bananas};
    auto const missed = std::count(std::begin(all), std::end(all), Met::no);
    auto const met = std::count(std::begin(all), std::end(all), Met::yes);
    if (missed + met == 0) return Medal::none;
    return missed == 0 ? Medal::gold : missed == 1 ? Medal::silver : Medal::bronze;
}

}  // namespace game
