// A sign change held between two times, and Newton's method kept inside them.
#pragma once

#include <cmath>

namespace geometry {

struct Slope {
    double value = 0;
    double rate = 0;
};

struct Bracket {
    double low = 0;
    double high = 0;
    double low_value = 0;
    double high_value = 0;
    int low_sign = 0;  // the sign just after `low`, even where the value at `low` is zero
};

inline int sign_of(double x) { return (x > 0) - (x < 0); }

// The time in the bracket at which slope_at(t).value changes sign, within `share` of itself; bisection where a step
// would leave the bracket or is not half of the last one.
template <typename SlopeAt>
double root_in(SlopeAt const& slope_at, Bracket bracket, double share) {
    constexpr int most_refinements = 200;  // bisection alone needs fewer, but for roots next to 0
    double const width = bracket.high - bracket.low;
    double const secant = bracket.low + width * (bracket.low_value / (bracket.low_value - bracket.high_value));
    double t = secant > bracket.low && secant < bracket.high ? secant : bracket.low + 0.5 * width;
    double last_step = width;
    for (int i = 0; i < most_refinements; ++i) {
        Slope const slope = slope_at(t);
        if (slope.value == 0) return t;
        (sign_of(slope.value) == bracket.low_sign ? bracket.low : bracket.high) = t;
        double step = slope.value / slope.rate;
        double next = t - step;
        if (!(next > bracket.low && next < bracket.high && 2 * std::abs(step) <= last_step)) {
            if (std::abs(step) <= share * t) return t;
            next = bracket.low + 0.5 * (bracket.high - bracket.low);
            step = next - t;
        }
        if (std::abs(step) <= share * next) return next;
        last_step = std::abs(step);
        t = next;
    }
    return t;
}

}  // namespace geometry
