// The damped oscillator y'' + 2 decay y' + stiffness y = 0 in closed form, all regimes in one formula (physics.md 3.2).
#pragma once

#include <cmath>

namespace geometry {

struct Oscillator {
    double decay = 0;      // 1/s, zeta omega
    double stiffness = 0;  // 1/s^2, omega^2
    // Known beforehand, as samplers would wait for them: decay^2 - stiffness, the root of its amount, and one over
    // that.
    double discriminant = 0;  // 1/s^2
    double root = 0;          // 1/s
    double root_inverse = 0;  // s; infinite at critical damping, where it is not used

    Oscillator() = default;
    Oscillator(double decay_, double stiffness_)
        : decay(decay_),
          stiffness(stiffness_),
          discriminant(decay * decay - stiffness),
          root(std::sqrt(std::abs(discriminant))),
          root_inverse(1 / root) {}
};

// The two basis solutions at time t: y(t) = y0 * cosine_like + (y0' + decay y0) * sine_like, where both
// carry the factor e^(-decay t).
struct Basis {
    double cosine_like = 1;
    double sine_like = 0;  // s
};
Basis basis_at(Oscillator const& oscillator, double t);

struct Swing {  // displacement and rate at one moment
    double displacement = 0;
    double rate = 0;
};
inline Swing swing_after(Oscillator const& o, Basis const& b, Swing const& start) {
    return {start.displacement * b.cosine_like + (start.rate + o.decay * start.displacement) * b.sine_like,
            start.rate * b.cosine_like - (o.decay * start.rate + o.stiffness * start.displacement) * b.sine_like};
}

// The largest |displacement| from `start` on, for all time, or a bound of it.
double envelope(Oscillator const& oscillator, Swing const& start);

}  // namespace geometry
