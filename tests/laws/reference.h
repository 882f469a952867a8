// The reference: one ball moved by brute force, in tiny steps and long double. It shares nothing with the methods but the
// curves of the terrain, and is no faster than it is clever: right to the first power of the step.
#pragma once

#include "physics/world/world.h"

namespace laws {

// Where the scene's first ball is after `time` under these forces, `step` (s) by `step`.
physics::State reference_after(physics::Scene const& scene, physics::Forces const& forces, double time, double step);

}  // namespace laws
