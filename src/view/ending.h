// The end of a game: what it was worth, and what falls from the sky.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "game/medals.h"
#include "level/level.h"
#include "view/moment.h"
#include "view/picture.h"

namespace view {

// What the window adds to what the game itself knows.
struct EndingNote {
    std::string hint;            // which key goes on
    std::optional<double> best;  // s, the best time before this one
};

// A disc on a ribbon; the number of its stars tells the metal without colour.
std::vector<Shape> medal_shapes(Vec2 const& at, double radius, game::Medal medal, float presence = 1);

// The card, and after the goal confetti; empty while the game goes on.
std::vector<Shape> ending_shapes(level::Level const& level, Moment const& moment, Vec2 const& size,
                                 EndingNote const& note);

}  // namespace view
