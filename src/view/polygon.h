// Closed polylines in metres: which way round, what lies inside, and bands that follow their edge.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "geometry/curve.h"

namespace view {

using geometry::Vec2;
using Ring = std::vector<Vec2>;

// Positive where the ring goes counter-clockwise.
double signed_area(Ring const& ring);
bool contains(Ring const& ring, Vec2 const& point);
geometry::Box box_of_ring(Ring const& ring);

enum class Closing { open, closed };

// Unit vectors to the left of the way along the points, at each point the mean of its two neighbours', lengthened so
// that a band of constant width stays one (to at most twice).
std::vector<Vec2> left_of(Ring const& points, Closing closing);

// The band between the points and the same points moved by width(i) along `into[i]`.
std::vector<Ring> band_along(std::span<Vec2 const> points, std::span<Vec2 const> into, Closing closing,
                             std::function<double(std::size_t)> const& width);

}  // namespace view
