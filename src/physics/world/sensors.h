// Sensors: what the legs of a history passed through, whatever method wrote them.
#pragma once

#include "physics/world/world.h"

namespace physics {

// No sensor has noticed anything yet.
std::vector<std::vector<bool>> nothing_noticed(Scene const& scene);

// m, how near to a region's edge counts as on it: entered, left, crossed.
inline constexpr double sensor_accuracy = 1e-11;

// Notes what every armed sensor notices in (from, to], and puts the events at their times into the history, before
// what else happens then. The times are the same however the same history is cut into windows.
void sense(Scene const& scene, World& world, double from, double to, History& history);

}  // namespace physics
