// Affine maps of the plane and the transform lists that write them.
#pragma once

#include <string_view>

#include "geometry/vector.h"

namespace level {

using geometry::Vec2;

// x' = a x + c y + e, y' = b x + d y + f, as in SVG's matrix(a b c d e f).
struct Affine {
    double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;
};

// First `inner`, then `outer`.
Affine composed(Affine const& outer, Affine const& inner);

Vec2 mapped(Affine const& map, Vec2 const& point);
Vec2 mapped_direction(Affine const& map, Vec2 const& direction);

double determinant(Affine const& map);

// By how much lengths grow, in the mean of all directions' areas: sqrt|determinant|.
double scale_of(Affine const& map);

// Programs write rotations with six or more decimals; a matrix this near to a similarity is meant as one.
inline constexpr double similarity_slack = 1e-6;  // relative to the matrix's size

// What per cent are of: a box in the units of the element that is transformed.
struct ReferenceBox {
    Vec2 corner = Vec2::Zero(), size = Vec2::Zero();
};

struct Transform {
    Affine map;
    bool in_attribute = true, in_style = true;  // whether browsers read it there, too
};

// A list of functions as attributes or style sheets write them; `whole` is what per cent are of. Throws Broken.
Transform parsed_transform(std::string_view text, Vec2 const& whole);

// "8 4.5", "50% 2px", "left", "bottom right" ... as a point. Throws Broken.
Vec2 parsed_origin(std::string_view text, ReferenceBox const& box);

// What the properties translate, rotate and scale write without the name of a function; nothing is none. Throws Broken.
Affine parsed_function(std::string_view name, std::string_view arguments, Vec2 const& whole);

// The map about a point in place of the origin.
Affine about(Vec2 const& point, Affine const& map);

}  // namespace level
