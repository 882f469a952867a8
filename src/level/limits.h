// How large a level may be, and how near is the same place (formats.md section 3).
#pragma once

namespace level {

inline constexpr double most_metres = 1e6;  // m, coordinates and radii
inline constexpr double most_speed = 1e6;   // m/s, of a ball's centre and of its rim

// A piece this short has both its ends in one vertex.
inline constexpr double shortest_piece = 1e-6;  // m

// Nearer to a curve its arcs would be shorter than the shortest piece, and without end.
inline constexpr double least_curve_tolerance = 1e-6;  // m

}  // namespace level
