#include "level/notes.h"

#include <algorithm>
#include <cmath>

#include "level/faults.h"

namespace level {

namespace {

// The nearest of 1, 2 or 5 times a power of ten that is not above the number.
double round_number(double number) {
    double const power = std::pow(10, std::floor(std::log10(number)));
    double const digit = number / power;
    return (digit >= 5 ? 5 : digit >= 2 ? 2 : 1) * power;
}

}  // namespace

std::vector<std::string> notes_on(Level const& level) {
    std::vector<std::string> notes;
    double const across = 2 * level.scene.balls[static_cast<std::size_t>(level.player)].radius;
    notes.push_back("the ball is " + shown(across) + " m across, the level " + shown(level.size.x()) + " m by " +
                    shown(level.size.y()) + " m");
    bool const of_another_scale = across > widest_ball || across < narrowest_ball;
    if (of_another_scale) {
        constexpr double usual_ball = 1;  // m across, about that of the levels that ship
        double const proposed = round_number(level.metres_per_unit * usual_ball / across);
        notes.push_back("data-metres-per-unit=\"" + shown(proposed) + "\" on the svg element would make the ball " +
                        shown(across * proposed / level.metres_per_unit) +
                        " m across; at another scale gravity does not feel as in the levels that ship");
    }
    bool const has_goal =
        std::find(level.meanings.begin(), level.meanings.end(), Meaning::goal) != level.meanings.end();
    if (!has_goal) notes.emplace_back("there is no goal and no way to win: give a shape the class goal");
    return notes;
}

}  // namespace level
