// A leg: the motion of one ball as a known function of time, in one phase, between two events. at() is the only
// sampler.
#pragma once

#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <variant>

#include "geometry/elliptic.h"
#include "geometry/oscillator.h"
#include "physics/motion/ball.h"
#include "physics/terrain/terrain.h"

namespace physics {

enum class Phase { flight, roll, slide, rest };

// What a stepping method writes: a straight line from one step to the next, with the state at its beginning.
struct Straight {
    State from;
    Vec2 rate = Vec2::Zero();  // m/s, the chord's, not the state's velocity
    double angle_rate = 0;     // rad/s
};

// Constant acceleration; standing still is the case in which all rates are zero.
struct Ballistic {
    State from;
    Vec2 acceleration = Vec2::Zero();  // m/s^2
    double spin_rate = 0;              // rad/s^2
};

// Flight on the drag spring: each axis swings about the equilibrium.
struct SpringFlight {
    State from;
    Vec2 equilibrium = Vec2::Zero();  // m
    geometry::Oscillator oscillator;
};

// Along a straight track on the drag spring. The angle is that of `from` + spin t + spin_rate t^2/2 when sliding,
// and follows the way rolled when rolling.
struct LineSwing {
    State from;
    Vec2 along = Vec2::UnitX();  // unit
    double displacement = 0;     // m, from the equilibrium, along `along`, at the beginning
    double speed = 0;            // m/s, along `along`, at the beginning
    geometry::Oscillator oscillator;
    double rolling = 0;    // 1/m: 1/r when rolling, 0 when sliding
    double spin_rate = 0;  // rad/s^2, when sliding
};

// Round a circular track: the polar angle, and the ball's own angle, as power series in the time since the leg began.
inline constexpr int series_order = 18;  // physics.md 3.9
using Series = std::array<double, series_order + 1>;
struct CircleSeries {
    Vec2 centre = Vec2::Zero();
    double rho = 0;  // m
    Series phi{};    // rad, rad/s, ...: the polar angle's coefficients
    Series angle{};  // the ball's angle
};
struct CircleRun {
    std::shared_ptr<CircleSeries const> series;
};

// Round a circular track as a pendulum of length rho: psi is the angle from where the field pulls to, counted in the
// sense in which the ball set out (physics.md 3.7).
struct Pendulum {
    Vec2 centre = Vec2::Zero();
    double rho = 0;             // m
    Vec2 down = Vec2::UnitX();  // unit, where psi is 0
    double phi_down = 0;        // rad, its polar angle, whole turns counted
    double sense = 1;           // of growing psi: +1 counter-clockwise
    bool turns_over = false;    // else it swings
    double swing = 1;           // sin(psi / 2) where it turns back
    double pace = 0;            // 1/s, of the functions' argument
    double phase = 0;           // the argument at the beginning
    geometry::Jacobi functions;
    double angle = 0;    // rad, the ball's own, where psi is 0
    double rolling = 0;  // how far the ball turns by how far it goes round
};
struct PendulumRun {
    std::shared_ptr<Pendulum const> pendulum;
};

using Motion = std::variant<Straight, Ballistic, SpringFlight, LineSwing, CircleRun, PendulumRun>;

inline constexpr double never = std::numeric_limits<double>::infinity();

struct Leg {
    double since = 0;      // s
    double until = never;  // s, the event that ends it, as far as is known
    Phase phase = Phase::flight;
    Contact contact;
    Motion motion;
};

inline State state_on(Ballistic const& m, double t) {
    Vec2 const mean = m.from.velocity + (0.5 * t) * m.acceleration;
    return {m.from.position + t * mean, m.from.velocity + t * m.acceleration,
            m.from.angle + t * (m.from.spin + 0.5 * t * m.spin_rate), m.from.spin + t * m.spin_rate};
}
State state_on(SpringFlight const& motion, double t);
State state_on(Motion const& motion, double t);

// The state `span` seconds after the leg began. Most motions are ballistic, and of those only what is asked for is
// worked out.
inline State at_span(Leg const& leg, double span) {
    auto const* ballistic = std::get_if<Ballistic>(&leg.motion);
    return ballistic ? state_on(*ballistic, span) : state_on(leg.motion, span);
}

// The state at time t, forward or back of the leg's ends as well. Never changes anything.
inline State at(Leg const& leg, double t) { return at_span(leg, t - leg.since); }

// The polar angle on a circular track `span` seconds after the leg began, whole turns counted; nothing on other ways.
std::optional<double> polar_angle_at(Motion const& motion, double span);

// An upper bound of |d^2 position/dt^2| over [from, to] within the leg, m/s^2.
double acceleration_bound(Leg const& leg, double from, double to);

}  // namespace physics
