// What lies behind the play and stays still while the camera does: sky, hills, decorations, ground.
#pragma once

#include <vector>

#include "level/level.h"
#include "view/camera.h"
#include "view/ground.h"
#include "view/picture.h"

namespace view {

std::vector<Shape> backdrop_shapes(level::Level const& level, Ground const& ground, Camera const& camera);

// Equal for equal level, camera and size; never 0.
unsigned long long backdrop_key_of(level::Level const& level, Camera const& camera);

}  // namespace view
