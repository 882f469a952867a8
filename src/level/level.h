// A level: a scene with names, a goal, bananas and a drawing. read_level makes one of an SVG file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "physics/scene.h"

namespace level {

using geometry::Vec2;

enum class Meaning { goal, banana, fall };

// One subpath of a terrain element or decoration, in the world, as drawn: for pictures only.
struct Outline {
    std::vector<geometry::Curve> curves;  // end to start
    bool closed = false;
};

// Drawn behind the scene and otherwise without effect.
struct Decoration {
    std::vector<Outline> outlines;
    std::optional<std::string> fill;    // a CSS colour as #rrggbb, none = not filled
    std::optional<std::string> stroke;  // the same
    double stroke_width = 0;            // m
    double opacity = 1;
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
    double drag_reach = 4;                   // m
    double tilt_limit = 0.4;                 // rad
    std::vector<Outline> outlines;           // of the terrain
    std::vector<Decoration> decorations;
    std::vector<Finding> misspellings;  // classes a letter away from a role, of which every command warns
};

// Throws std::runtime_error("file:line: element: what") for the first fault (formats.md section 3).
Level read_level(std::string const& file);

// Every fault that can be reached, then what is legal but suspicious; in order of lines.
std::vector<Finding> findings_in(std::string const& file);

}  // namespace level
