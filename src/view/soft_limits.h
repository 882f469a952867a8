// Limits without a bend, so that what moves up to one stops softly.
#pragma once

#include <algorithm>
#include <cmath>

namespace view {

// Up to the limits exactly x; smooth, and never beyond `most`, where |x| exceeds `free`.
inline double softly_limited(double x, double free, double most) {
    double const beyond = std::abs(x) - free, room = most - free;
    if (beyond <= 0) return x;
    return std::copysign(free + room * std::tanh(beyond / room), x);
}

// max(x, low) with a parabola in place of the bend; never below `low`, and x itself from low + width on.
inline double softly_above(double x, double low, double width) {
    if (x >= low + width) return x;
    if (x <= low - width) return low;
    double const rise = x - low + width;
    return low + rise * rise / (4 * width);
}

inline double softly_within(double x, double low, double high) {
    double const width = std::min(1.5, (high - low) / 4);
    if (!(width > 0)) return (low + high) / 2;
    return -softly_above(-softly_above(x, low, width), -high, width);
}

}  // namespace view
