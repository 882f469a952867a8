// When a gap made of a straight line and a damped oscillation closes; every extremum is visited, none is stepped over.
#pragma once

#include <optional>

#include "geometry/oscillator.h"

namespace geometry {

struct SwingSearch {
    std::optional<double> time;  // s, the first fall
    double searched_until = 0;   // s, there is no fall before this; less than asked only if the search gave up
};

// The first t in [0, until] at which c0 + c1 t + y(t) is not above zero and is closing, by the rule of first_fall
// (polynomial.h); y is the motion of the oscillator from `start`. Decay and stiffness must not be negative; `until` may
// be infinite. All zeros of y'' have a closed form; between them y' + c1 is monotone (physics.md 11.2).
SwingSearch first_swing_fall(double c0, double c1, Oscillator const& oscillator, Swing const& start, double until);

}  // namespace geometry
