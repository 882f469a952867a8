// The shape of a drawn element in the drawing's own units: path, line, polyline, polygon, rect, circle, ellipse.
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <pugixml.hpp>

#include "level/faults.h"
#include "level/svg_path.h"

namespace level {

struct Ellipse {
    Vec2 centre = Vec2::Zero();
    double rx = 0, ry = 0;
};
using Shape = std::variant<std::vector<Subpath>, Ellipse>;

bool is_shape(std::string_view tag);

// `viewport` is the size that per cent are of. Throws Broken("d: unknown command x at ..."), and Unsupported for a
// radius or size that is not positive and a length in a unit that depends on fonts or windows.
Shape shape_of(pugi::xml_node node, std::string_view tag, Vec2 const& viewport);

// The four corners of a rect in their order. Throws as shape_of does.
std::vector<Vec2> corners_of_rect(pugi::xml_node node, Vec2 const& viewport);

// Both ends of a line element. Throws as shape_of does.
std::vector<Vec2> ends_of_line(pugi::xml_node node, Vec2 const& viewport);

// Which attributes place a shape too far away, or make it too round, under a transform that enlarges by `scale`: those
// that are beyond the limit by themselves, else all that say where, or how round, the shape is. "cx, cy"
std::string far_attributes(pugi::xml_node node, std::string_view tag, double scale, TooFar const& far);

// Whether a rect has round corners. Throws as shape_of does.
bool has_round_corners(pugi::xml_node node, Vec2 const& viewport);

}  // namespace level
