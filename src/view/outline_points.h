// Outlines of terrain as points, for pictures.
#pragma once

#include <vector>

#include "level/level.h"

namespace view {

using geometry::Vec2;

inline constexpr double unseen_flatness = 0.0005;  // m: how far a chord may lie from its arc

// Of the points along edges, m: near enough for grass and to the eye, and coarser where a drawing has so much of it
// that nobody sees it.
struct Fineness {
    double spacing, flatness;
};
Fineness fineness_for(level::Level const& level);

// Points along an outline whose chords lie no further from it than `flatness` and are no longer than `spacing`, m.
std::vector<Vec2> points_along(level::Outline const& outline, double spacing, double flatness = unseen_flatness);

}  // namespace view
