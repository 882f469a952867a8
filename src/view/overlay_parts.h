// The overlays one by one, and what they draw on: arrows in the world, tables at an edge.
#pragma once

#include <string>
#include <vector>

#include "view/hud.h"
#include "view/overlay.h"

namespace view {

// Collects shapes; tables of one part are placed one below the other.
inline constexpr double table_width = 268;  // pixels of a picture of 1280x720
struct Slate {
    std::vector<Shape>* shapes = nullptr;
    Camera const* camera = nullptr;
    double table_left = 0;     // pixels
    double next_table = 0;     // pixels from the top
    std::vector<Panel> names;  // of arrows that have been drawn: later ones stand clear of them
    game::Language language = game::Language::english;
};

struct Arrow {
    Vec2 from = Vec2::Zero();  // m
    Vec2 way = Vec2::Zero();   // m, as long as it is drawn
    Colour paint;
    std::string name;
    double side = 1;  // of its tip on which the name stands: 1 to the left of the way as it is seen, -1 to the right
};
void draw_arrow(Slate& slate, Arrow const& arrow);

struct Row {
    std::string name, value;
    Colour paint;
};
void draw_table(Slate& slate, std::string const& title, std::vector<Row> const& rows);

void draw_figures(Slate& slate, level::Level const& level, Moment const& moment);
void draw_forces(Slate& slate, level::Level const& level, Moment const& moment);
void draw_energy(Slate& slate, level::Level const& level, Moment const& moment);

}  // namespace view
