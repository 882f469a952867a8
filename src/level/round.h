// Shapes that are circles, however they are drawn: balls, bananas and round goals.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "level/level.h"
#include "level/shapes.h"
#include "level/transform.h"

namespace level {

inline constexpr double roundness = 1e-3;  // of the radius, docs/levels.md: how far a circle may be from one

// The disc in the world that a shape is; none where it is no circle. Throws Broken where it is one of no size or
// beyond the limits.
std::optional<physics::DiscRegion> disc_of(Shape const& shape, Affine const& to_world);

// Why it is none, and what to do.
std::string why_not_round(Shape const& shape, Affine const& to_world, std::string_view tag);

}  // namespace level
