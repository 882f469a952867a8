// A sketch: a level of one ball and a run on it as plain data, which can be drawn, changed and written as SVG.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "game/game.h"

namespace hunt {

using geometry::Vec2;

// Strokes in the world: y up, m.
struct Line {
    Vec2 from = Vec2::Zero(), to = Vec2::Zero();
};
struct Bow {  // a circular arc as SVG says it
    Vec2 from = Vec2::Zero(), to = Vec2::Zero();
    double radius = 1;
    bool large = false;  // more than half a turn
    bool left = true;    // counter-clockwise
};
struct Cubic {
    Vec2 from = Vec2::Zero(), first = Vec2::Zero(), second = Vec2::Zero(), to = Vec2::Zero();
};
struct Quadratic {
    Vec2 from = Vec2::Zero(), handle = Vec2::Zero(), to = Vec2::Zero();
};
struct Disc {
    Vec2 centre = Vec2::Zero();
    double radius = 1;
};
using Stroke = std::variant<Line, Bow, Cubic, Quadratic, Disc>;

Vec2 from_of(Stroke const& stroke);  // of a disc, where it begins and ends: to the right of its centre
Vec2 to_of(Stroke const& stroke);

// One element of the drawing. Strokes that go on where the one before ended are written as one subpath.
struct Element {
    std::vector<Stroke> strokes;
    physics::Material material;
};

struct Sketch {
    double width = 16, height = 9;  // m; the world's origin is the lower left corner
    double gravity = 9.81;
    double drag_frequency = 3, drag_damping = 0.7, drag_reach = 4;
    std::vector<Element> elements;
    physics::Ball ball;
    std::vector<game::Input> inputs;
    double duration = 12;  // s
};

std::string svg_of(Sketch const& sketch);

// The sketch as the program reads it. Throws std::runtime_error where it refuses it.
level::Level level_of(Sketch const& sketch);

}  // namespace hunt
