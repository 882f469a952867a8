// Sensors: what the legs of a history passed through, whatever method wrote them.
#pragma once

#include "physics/world.h"

namespace physics {

// No sensor has noticed anything yet.
std::vector<std::vector<bool>> nothing_noticed(Scene const& scene);

// Notes what every armed sensor notices over [from, to], and puts the events at their times into the history.
// Regions are found by conservative advancement on |acceleration| <= M (physics.md 3.2), to `sensor_accuracy`.
inline constexpr double sensor_accuracy = 1e-11;  // m, how near to the region's edge counts as on it
void sense(Scene const& scene, World& world, double from, double to, History& history);

}  // namespace physics
