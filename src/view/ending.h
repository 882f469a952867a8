// The end of a game: what it was worth, and what falls from the sky.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "game/medals.h"
#include "game/texts.h"
#include "level/level.h"
#include "view/camera.h"
#include "view/moment.h"
#include "view/picture.h"

namespace view {

// What the window adds to what the game itself knows.
struct EndingNote {
    std::string hint;            // which key goes on
    std::optional<double> best;  // s, the best time before this one
    game::Language language = game::Language::english;
    Motion motion = Motion::full;  // reduced: no confetti, and cards are there at once
    std::string film;              // what the button says that films the run, on the card after the goal; empty = none
};

// A disc on a ribbon; the number of its stars tells the metal without colour.
std::vector<Shape> medal_shapes(Vec2 const& at, double radius, game::Medal medal, float presence = 1);

// Whether a pixel is on that button. False where there is none.
bool is_on_film_button(level::Level const& level, Moment const& moment, Vec2 const& pixel, Vec2 const& size,
                       EndingNote const& note);

// The card, and after the goal confetti; empty while the game goes on.
std::vector<Shape> ending_shapes(level::Level const& level, Moment const& moment, Vec2 const& size,
                                 EndingNote const& note);

}  // namespace view
