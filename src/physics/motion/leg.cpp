#include "physics/motion/leg.h"

#include <algorithm>
#include <cmath>

#include "geometry/elementary.h"

namespace physics {

using geometry::Swing;

State state_on(SpringFlight const& m, double t) {
    geometry::Basis const basis = geometry::basis_at(m.oscillator, t);
    Vec2 const d = m.from.position - m.equilibrium;
    Swing const x = swing_after(m.oscillator, basis, {d.x(), m.from.velocity.x()});
    Swing const y = swing_after(m.oscillator, basis, {d.y(), m.from.velocity.y()});
    return {m.equilibrium + Vec2(x.displacement, y.displacement), Vec2(x.rate, y.rate), m.from.angle + t * m.from.spin,
            m.from.spin};
}

namespace {

State state_on(Straight const& m, double t) {
    if (t == 0) return m.from;
    return {m.from.position + t * m.rate, m.from.velocity, m.from.angle + t * m.angle_rate, m.from.spin};
}

State state_on(LineSwing const& m, double t) {
    geometry::Basis const basis = geometry::basis_at(m.oscillator, t);
    Swing const q = swing_after(m.oscillator, basis, {m.displacement, m.speed});
    double const way = q.displacement - m.displacement;
    State state;
    state.position = m.from.position + way * m.along;
    state.velocity = q.rate * m.along;
    if (m.rolling > 0) {
        state.angle = m.from.angle - m.rolling * way;
        state.spin = -m.rolling * q.rate;
    } else {
        state.angle = m.from.angle + t * (m.from.spin + 0.5 * t * m.spin_rate);
        state.spin = m.from.spin + t * m.spin_rate;
    }
    return state;
}

struct Value {
    double value = 0;
    double rate = 0;
};

// Even and odd powers apart, in t^2: each is a chain of sums that wait for each other, and four short chains at once
// take half as long as two long ones.
Value series_at(Series const& series, double t) {
    static_assert(series_order % 2 == 0);
    double const square = t * t;
    double even = series[series_order], even_rate = 0, odd = 0, odd_rate = 0;
    for (int i = series_order - 2; i >= 0; i -= 2) {
        even_rate = even_rate * square + even;
        odd_rate = odd_rate * square + odd;
        even = even * square + series[i];
        odd = odd * square + series[i + 1];
    }
    return {even + t * odd, odd + 2 * (t * even_rate + square * odd_rate)};
}

State state_on(CircleRun const& m, double t) {
    CircleSeries const& s = *m.series;
    auto const [phi, phi_rate] = series_at(s.phi, t);
    auto const [angle, angle_rate] = series_at(s.angle, t);
    auto const [sine, cosine] = geometry::sine_cosine(phi);
    return {s.centre + s.rho * Vec2(cosine, sine), (s.rho * phi_rate) * Vec2(-sine, cosine), angle, angle_rate};
}

// Half of psi as the pendulum's functions give it: sin(psi / 2) is swing sn or, turning over, sn.
struct HalfAngle {
    double sine = 0, cosine = 1;
    double rate = 0;        // 1/s
    double half_turns = 0;  // of the half angle, when turning over
    double psi() const { return 2 * (geometry::arctangent(sine, cosine) + geometry::pi * half_turns); }
};
HalfAngle half_angle_at(Pendulum const& m, double t) {
    geometry::Jacobi::Values const f = m.functions.at(m.phase + m.pace * t);
    if (m.turns_over) return {f.sn, f.cn, m.pace * f.dn, f.half_turns};
    double const swing = f.sign * m.swing;
    return {swing * f.sn, f.dn, m.pace * (swing * f.cn), 0};
}

State state_on(PendulumRun const& run, double t) {
    Pendulum const& m = *run.pendulum;
    HalfAngle const half = half_angle_at(m, t);
    double const cosine = (half.cosine - half.sine) * (half.cosine + half.sine);
    double const sine = m.sense * (2 * half.sine * half.cosine);
    Vec2 const out = geometry::turned(m.down, cosine, sine);
    double const rate = m.sense * (2 * half.rate);
    return {m.centre + m.rho * out, (m.rho * rate) * geometry::turned_left(out),
            m.angle + m.rolling * (m.sense * half.psi()), m.rolling * rate};
}

// The acceleration of a swing is a swing of the same oscillator.
double swing_acceleration_bound(geometry::Oscillator const& o, Swing const& start) {
    double const acceleration = -2 * o.decay * start.rate - o.stiffness * start.displacement;
    double const jerk = -2 * o.decay * acceleration - o.stiffness * start.rate;
    return envelope(o, {acceleration, jerk});
}

struct AccelerationBound {
    double from, to;  // s since the leg began

    double operator()(Straight const&) const { return 0; }
    double operator()(Ballistic const& m) const { return geometry::length(m.acceleration); }
    double operator()(SpringFlight const& m) const {
        State const start = state_on(m, from);
        Vec2 const d = start.position - m.equilibrium;
        double const x = swing_acceleration_bound(m.oscillator, {d.x(), start.velocity.x()});
        double const y = swing_acceleration_bound(m.oscillator, {d.y(), start.velocity.y()});
        return std::sqrt(x * x + y * y);
    }
    double operator()(LineSwing const& m) const {
        geometry::Basis const basis = geometry::basis_at(m.oscillator, from);
        return swing_acceleration_bound(m.oscillator, swing_after(m.oscillator, basis, {m.displacement, m.speed}));
    }
    double operator()(CircleRun const& m) const {
        Series const& phi = m.series->phi;
        double const t = std::max(std::abs(from), std::abs(to));
        double rate = 0, acceleration = 0;
        for (std::size_t i = phi.size(); i-- > 1;) {
            double const order = static_cast<double>(i);
            rate = rate * t + order * std::abs(phi[i]);
            if (i > 1) acceleration = acceleration * t + order * (order - 1) * std::abs(phi[i]);
        }
        return m.series->rho * std::sqrt(acceleration * acceleration + rate * rate * rate * rate);
    }
    // psi'^2 <= 4 (swing pace)^2, and |psi''| <= pace^2.
    double operator()(PendulumRun const& run) const {
        Pendulum const& m = *run.pendulum;
        double const fastest = 4 * (m.swing * m.pace) * (m.swing * m.pace);
        double const own = m.pace * m.pace;
        return m.rho * std::sqrt(own * own + fastest * fastest);
    }
};

}  // namespace

State state_on(Motion const& motion, double t) {
    return std::visit([t](auto const& kind) { return state_on(kind, t); }, motion);
}

std::optional<double> polar_angle_at(Motion const& motion, double span) {
    if (auto const* run = std::get_if<CircleRun>(&motion)) return series_at(run->series->phi, span).value;
    auto const* run = std::get_if<PendulumRun>(&motion);
    if (run == nullptr) return std::nullopt;
    Pendulum const& m = *run->pendulum;
    return m.phi_down + m.sense * half_angle_at(m, span).psi();
}

double acceleration_bound(Leg const& leg, double from, double to) {
    return std::visit(AccelerationBound{from - leg.since, to - leg.since}, leg.motion);
}

}  // namespace physics
