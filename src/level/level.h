// A level: a scene with names, a goal, bananas and a drawing. read_level makes one of an SVG file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/fill_rule.h"
#include "physics/world/scene.h"

namespace level {

using geometry::Vec2;

enum class Meaning { goal, banana, fall };

// One subpath of a terrain element or decoration, in the world, as drawn: for pictures only.
struct Outline {
    std::vector<geometry::Curve> curves;  // end to start
    bool closed = false;
    bool painted = false;  // of terrain that the drawing paints itself: no grass and no soil
};

// A fill that goes evenly from one colour to another down the world, and keeps them beyond.
struct Fade {
    std::string top, bottom;  // CSS colours as #rrggbb
    double top_opacity = 1, bottom_opacity = 1;
    double top_y = 0, bottom_y = 0;  // m, where it begins and ends
};

// What the drawing paints itself: drawn behind the scene and otherwise without effect.
struct Decoration {
    std::vector<Outline> outlines;
    std::optional<std::string> fill;    // a CSS colour as #rrggbb, none = not filled
    std::optional<std::string> stroke;  // the same
    double stroke_width = 0;            // m
    double opacity = 1;
    geometry::FillRule fill_rule = geometry::FillRule::even_odd;
    std::optional<Fade> fade = std::nullopt;  // what fills it; `fill` and `opacity` are its means then
};

// The colours that the drawing gives a ball or a goal, as in Decoration; what it leaves open is the program's to
// choose.
struct Tint {
    std::optional<std::string> fill, stroke;
};

// What lies behind the play, in colours as #rrggbb; what is empty is as the game has it. "none" leaves out.

inline constexpr char no_colour[] = "none";
struct Look {
    std::vector<std::string> sky;    // above, below
    std::vector<std::string> hills;  // far, middle, near
    std::string sun, clouds;
};

// What there is to do better than merely to arrive. Every banana counts beside these.
struct Pars {
    std::optional<double> time;  // s
    std::optional<int> pulls;    // how often a ball is taken
};

struct Finding {
    int line = 0;
    std::string text;    // "element: what"
    bool fault = false;  // else a warning
};

struct Level {
    std::string title;
    std::string file;      // the path it was read from
    std::string hash;      // FNV-1a of the file's bytes, 16 hex digits
    physics::Scene scene;  // scene.sensors[i] means meanings[i]
    std::vector<Meaning> meanings;
    std::vector<int> sensor_elements;        // by sensor: which drawn element it is; a goal may have several parts
    std::vector<std::string> surface_names;  // by Piece::surface: the element's id or its number in the file
    int player = 0;                          // index of the player's ball
    Vec2 size = Vec2::Zero();                // m, of the viewBox; its lower left corner is the origin
    double metres_per_unit = 1;              // of the drawing
    std::optional<double> time_limit;        // s
    std::string hint;                        // the drawing's <desc>
    double drag_reach = 4;                   // m; 0 = nothing can be pulled
    double tilt_limit = 0.4;                 // rad
    Pars pars;
    Look look;
    std::vector<Outline> outlines;        // of the terrain
    std::vector<Decoration> decorations;  // and terrain that the drawing paints, in the order of the file
    std::optional<std::size_t> in_front;  // of grass and soil: the decorations from this one on
    std::vector<Tint> ball_tints;         // by ball
    std::vector<Tint> sensor_tints;       // by sensor, of goals
    std::vector<Finding> remarks;         // on what looks otherwise than it is; check prints them as notes
    std::vector<Finding> misspellings;    // classes a letter away from a role, of which every command warns
};

// Throws std::runtime_error("file:line: element: what") for the first fault (docs/levels.md).
Level read_level(std::string const& file);

// What check knows of a file.
struct Checked {
    std::vector<Finding> findings;  // every fault that can be reached, and what is legal but suspicious; by line
    std::optional<Level> level;     // where there is no fault
};
// Throws std::runtime_error where the file cannot be opened.
Checked checked_level(std::string const& file);

}  // namespace level
