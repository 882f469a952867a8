// What is legal in a level but suspicious: hardly visible slips of the hand that change how balls roll.
#pragma once

#include "level/reading.h"

namespace level {

inline constexpr double widest_gap = 1e-3;  // m, docs/levels.md: ends that look joined and are not
inline constexpr double largest_break = 2 * 3.14159265358979323846 / 180;  // rad, turns that look smooth and are not

// Adds warnings to the report: gaps, tangent breaks, arcs tighter than a ball, balls inside terrain or out of the page.
void add_suspicions(Reading& reading);

}  // namespace level
