// Shapes that are circles, however they are drawn: balls, bananas and round goals.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "level/level.h"
#include "level/shapes.h"
#include "level/transform.h"

namespace level {

// Of the radius, docs/levels.md: how far a circle may be from one. Programs that make it of Bezier curves round these
// to their grid: LibreOffice writes one of 5 mm in whole hundredths of mm.
inline constexpr double roundness = 1e-3, roundness_of_beziers = 5e-3;

// The disc in the world that a shape is; none where it is no circle. Throws Broken where it is one of no size or
// beyond the limits.
std::optional<physics::DiscRegion> disc_of(Shape const& shape, Affine const& to_world);

// Why it is none, and what to do.
std::string why_not_round(Shape const& shape, Affine const& to_world, std::string_view tag);

}  // namespace level
