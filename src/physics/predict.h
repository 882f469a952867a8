// What is going to happen if nothing is done: the coming legs and events.
#pragma once

#include "physics/method.h"

namespace physics {

// From the world's present to `horizon` seconds later; the world is not touched. Sensors fire there as they will.
History predicted(Method const& method, Scene const& scene, World const& world, double horizon);

}  // namespace physics
