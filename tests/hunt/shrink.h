// Cuts a case down to what the failure hangs on.
#pragma once

#include <functional>

#include "hunt/sketch.h"

namespace hunt {

// Fewer elements, strokes and inputs, a shorter run, plainer numbers, as long as `fails` says that it fails as before.
// Only sketches whose ball starts clear of the ground as drawn are asked about.
Sketch shrunk(Sketch const& sketch, double fails_at, std::function<bool(Sketch const&)> const& fails);

}  // namespace hunt
