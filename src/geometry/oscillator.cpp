#include "geometry/oscillator.h"

#include <cmath>
#include <limits>

#include "geometry/elementary.h"

namespace geometry {

namespace {

// Below this |D| t^2 the series is exact to rounding, and both closed forms would lose digits (physics.md 3.2).
constexpr double series_limit = 1e-2;

// cosh(sqrt(q)) and t sinh(sqrt(q)) / sqrt(q), times a factor; both are entire in q, of either sign.
Basis near_critical(double q, double t, double factor) {
    double const cosine_like = 1 + q * (1.0 / 2 + q * (1.0 / 24 + q * (1.0 / 720 + q * (1.0 / 40320))));
    double const sine_like = 1 + q * (1.0 / 6 + q * (1.0 / 120 + q * (1.0 / 5040 + q * (1.0 / 362880))));
    return {factor * cosine_like, factor * t * sine_like};
}

// The two exponents are combined with the decay first: neither can overflow.
Basis overdamped(Oscillator const& o, double t) {
    double const fast_rate = o.decay + o.root;
    double const slow_rate = o.stiffness / fast_rate;
    double const slow = slow_rate == 0 ? 1 : exponential(-slow_rate * t);
    double const fast = exponential(-fast_rate * t);
    return {0.5 * (slow + fast), 0.5 * (slow - fast) * o.root_inverse};
}

}  // namespace

Basis basis_at(Oscillator const& oscillator, double t) {
    double const q = oscillator.discriminant * t * t;
    if (q > series_limit) return overdamped(oscillator, t);
    double const factor = oscillator.decay == 0 ? 1 : exponential(-oscillator.decay * t);
    if (factor == 0) return {0, 0};
    if (!(q < -series_limit)) return near_critical(q, t, factor);
    SineCosine const turn = sine_cosine(oscillator.root * t);
    return {factor * turn.cosine, factor * turn.sine * oscillator.root_inverse};
}

double envelope(Oscillator const& o, Swing const& start) {
    double const slope = std::abs(start.rate + o.decay * start.displacement);
    if (o.discriminant < 0) return std::sqrt(start.displacement * start.displacement - slope * slope / o.discriminant);
    // Overdamped: |y| <= |y0| + |slope| max(t e^(-slow t)), with `slow` the slower of the two rates.
    double const slow = o.stiffness > 0 ? o.stiffness / (o.decay + o.root) : 0;
    double const bound = slow > 0 ? slope * exponential(-1) / slow : std::numeric_limits<double>::infinity();
    return std::abs(start.displacement) + bound;
}

}  // namespace geometry
