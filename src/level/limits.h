// How large a level may be, and how near is the same place (docs/levels.md).
#pragma once

#include <cstddef>

namespace level {

inline constexpr double most_metres = 1e6;  // m, coordinates and radii
inline constexpr double most_speed = 1e6;   // m/s, of a ball's centre and of its rim

// Lines and curves of one path, and pieces that all shapes of a level become: a packed file may hold far more than
// memory does.
inline constexpr std::size_t most_pieces = 1'000'000;

// A piece this short has both its ends in one vertex.
inline constexpr double shortest_piece = 1e-6;  // m

// Nearer to a curve its arcs would be shorter than the shortest piece, and without end.
inline constexpr double least_curve_tolerance = 1e-6;  // m

}  // namespace level
