// The shape of a drawn element in the drawing's own units: path, line, polyline, polygon, rect, circle, ellipse.
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <pugixml.hpp>

#include "level/svg_path.h"

namespace level {

struct Ellipse {
    Vec2 centre = Vec2::Zero();
    double rx = 0, ry = 0;
};
using Shape = std::variant<std::vector<Subpath>, Ellipse>;

bool is_shape(std::string_view tag);

// Throws Broken("d: unknown command x at ..."), and for a radius or size that is not positive or a length in a unit
// other than px.
Shape shape_of(pugi::xml_node node, std::string_view tag);

// The four corners of a rect in their order. Throws Broken as shape_of does.
std::vector<Vec2> corners_of_rect(pugi::xml_node node);

// A length in user units, plain or in px. Throws Broken naming the attribute.
double length_in(pugi::xml_node node, char const* attribute);

// Which attributes place a shape too far away under a transform that enlarges by `scale`: those that are beyond the
// limit by themselves, else all that say where the shape is. "cx, cy"
std::string far_coordinates(pugi::xml_node node, std::string_view tag, double scale);

// Whether a rect has round corners. Throws Broken as shape_of does.
bool has_round_corners(pugi::xml_node node);

}  // namespace level
