// The kinds of levels that the hunt draws, and how a case is drawn from a seed.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "hunt/dice.h"
#include "hunt/sketch.h"

namespace hunt {

// Draws the ground of a sketch whose ball has its radius already, and says where the ball is best let go, if anywhere.
using Drawing = std::vector<Vec2> (*)(Dice& dice, Sketch& sketch);

std::vector<Vec2> draw_lines(Dice& dice, Sketch& sketch);
std::vector<Vec2> draw_arcs(Dice& dice, Sketch& sketch);
std::vector<Vec2> draw_stones(Dice& dice, Sketch& sketch);
std::vector<Vec2> draw_grid(Dice& dice, Sketch& sketch);
std::vector<Vec2> draw_curves(Dice& dice, Sketch& sketch);
std::vector<Vec2> draw_gaps(Dice& dice, Sketch& sketch);
std::vector<Vec2> draw_narrow(Dice& dice, Sketch& sketch);
std::vector<Vec2> draw_twice(Dice& dice, Sketch& sketch);
std::vector<Vec2> draw_zero_g(Dice& dice, Sketch& sketch);
std::vector<Vec2> draw_rounded(Dice& dice, Sketch& sketch);

struct Kind {
    char const* name;
    Drawing draw;
};
std::span<Kind const> kinds();

// All kinds without and with a player: "arcs", "arcs+player", ...
std::vector<std::string> kind_names();

// Throws std::invalid_argument for a kind that does not exist.
Sketch sketch_of(std::string const& kind, std::uint64_t seed);

// Whether the ball is let go clear of the ground as drawn; curves are read to a millimetre.
bool starts_clear(Sketch const& sketch);

// Parts that several kinds share.
physics::Material drawn_material(Dice& dice);
void add_box(Sketch& sketch, physics::Material const& material, double corner_radius);
// Numbers as people draw them, to the centimetre, or with all their digits.
Vec2 drawn_point(Dice& dice, Sketch const& sketch);
Drawing any_ground(Dice& dice);  // one of lines, arcs, stones, grid

// Presses, moves, lets go and tilts at random, and the spring by which it does so.
void add_player(Dice& dice, Sketch& sketch);

}  // namespace hunt
