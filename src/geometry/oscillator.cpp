#include "geometry/oscillator.h"

#include <cmath>

#include "geometry/elementary.h"

namespace geometry {

namespace {

// Below this |D| t^2 the series is exact to rounding, and both closed forms would lose digits (physics.md 2.2).
constexpr double series_limit = 1e-2;

// cosh(sqrt(q)) and t sinh(sqrt(q)) / sqrt(q), times a factor; both are entire in q, of either sign.
Basis near_critical(double q, double t, double factor) {
    double const cosine_like = 1 + q * (1.0 / 2 + q * (1.0 / 24 + q * (1.0 / 720 + q * (1.0 / 40320))));
    double const sine_like = 1 + q * (1.0 / 6 + q * (1.0 / 120 + q * (1.0 / 5040 + q * (1.0 / 362880))));
    return {factor * cosine_like, factor * t * sine_like};
}

// The two exponents are combined with the decay first: neither can overflow.
Basis overdamped(Oscillator const& o, double root, double t) {
    double const fast_rate = o.decay + root;
    double const slow_rate = o.stiffness / fast_rate;
    double const slow = slow_rate == 0 ? 1 : exponential(-slow_rate * t);
    double const fast = exponential(-fast_rate * t);
    return {0.5 * (slow + fast), 0.5 * (slow - fast) / root};
}

}  // namespace

Basis basis_at(Oscillator const& oscillator, double t) {
    double const discriminant = oscillator.decay * oscillator.decay - oscillator.stiffness;
    double const q = discriminant * t * t;
    if (q > series_limit) return overdamped(oscillator, std::sqrt(discriminant), t);
    double const factor = oscillator.decay == 0 ? 1 : exponential(-oscillator.decay * t);
    if (factor == 0) return {0, 0};
    if (!(q < -series_limit)) return near_critical(q, t, factor);
    double const frequency = std::sqrt(-discriminant);
    SineCosine const turn = sine_cosine(frequency * t);
    return {factor * turn.cosine, factor * turn.sine / frequency};
}

}  // namespace geometry
