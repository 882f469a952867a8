#include "physics/motion/leg_bounds.h"

#include <algorithm>
#include <cmath>

#include "geometry/elementary.h"

namespace physics {

using geometry::dot;
using geometry::Swing;

namespace {

constexpr double full_turn = 2 * geometry::pi;

// The acceleration of a swing is a swing of the same oscillator.
double acceleration_of(geometry::Oscillator const& o, Swing const& start) {
    double const acceleration = -2 * o.decay * start.rate - o.stiffness * start.displacement;
    double const jerk = -2 * o.decay * acceleration - o.stiffness * start.rate;
    return envelope(o, {acceleration, jerk});
}

// |d^2 phi/dt^2| of the polar angle, 1/s^2, on [from, to].
double angular_acceleration(CircleRun const& run, double from, double to) {
    Series const& phi = run.series->phi;
    double const t = std::max(std::abs(from), std::abs(to));
    double bound = 0;
    for (std::size_t i = phi.size(); i-- > 2;) {
        double const order = static_cast<double>(i);
        bound = bound * t + order * (order - 1) * std::abs(phi[i]);
    }
    return bound;
}

// psi'' = -(pace k)^2 sin psi turning over, -pace^2 sin psi swinging, where |sin(psi / 2)| <= swing.
double angular_acceleration(PendulumRun const& run, double, double) {
    Pendulum const& m = *run.pendulum;
    return m.pace * m.pace * (m.turns_over ? 1 : std::min(1.0, 2 * m.swing));
}

bool holds_turn(Range const& angles, double angle) {
    return std::ceil((angles.low - angle) / full_turn) * full_turn + angle <= angles.high;
}

// Of the cosines of the angles in a range.
Range cosines_of(Range const& angles) {
    if (!(angles.high - angles.low < full_turn)) return {-1, 1};
    double const first = geometry::sine_cosine(angles.low).cosine, last = geometry::sine_cosine(angles.high).cosine;
    double const low = std::min(first, last), high = std::max(first, last);
    return {holds_turn(angles, geometry::pi) ? -1 : low, holds_turn(angles, 0) ? 1 : high};
}

// Of the cosine of the angle between the directions and one direction (any length).
Range cosines_to(Range const& angles, Vec2 const& direction) {
    double const angle = geometry::arctangent(direction.y(), direction.x());
    return cosines_of({angles.low - angle, angles.high - angle});
}

}  // namespace

LegPart::LegPart(Leg const& leg, double from, double to) : leg_(leg), from_(from), to_(to) {
    auto const keep_round = [&](auto const& run, Vec2 const& centre, double rho) {
        double const first = *polar_angle_at(leg.motion, from), last = *polar_angle_at(leg.motion, to);
        double const slack = sag(angular_acceleration(run, from, to));
        round_ = Round{centre, rho, {std::min(first, last) - slack, std::max(first, last) + slack}};
    };
    if (auto const* run = std::get_if<CircleRun>(&leg.motion))
        keep_round(*run, run->series->centre, run->series->rho);
    else if (auto const* pendulum = std::get_if<PendulumRun>(&leg.motion))
        keep_round(*pendulum, pendulum->pendulum->centre, pendulum->pendulum->rho);
    if (round_) return;
    begin_ = at_span(leg, from).position;
    end_ = at_span(leg, to).position;
}

double LegPart::acceleration_along(Vec2 const& direction) const {
    if (auto const* m = std::get_if<Ballistic>(&leg_.motion)) return std::abs(dot(m->acceleration, direction));
    if (auto const* m = std::get_if<SpringFlight>(&leg_.motion)) {
        State const start = at_span(leg_, from_);
        return acceleration_of(m->oscillator,
                               {dot(start.position - m->equilibrium, direction), dot(start.velocity, direction)});
    }
    if (auto const* m = std::get_if<LineSwing>(&leg_.motion))
        return std::abs(dot(m->along, direction)) * acceleration();
    return 0;
}

double LegPart::acceleration() const { return acceleration_bound(leg_, leg_.since + from_, leg_.since + to_); }

Range LegPart::along(Vec2 const& origin, Vec2 const& direction) const {
    if (round_) {
        Range const cosines = cosines_to(round_->angles, direction);
        double const middle = dot(round_->centre - origin, direction);
        return {middle + round_->rho * cosines.low, middle + round_->rho * cosines.high};
    }
    double const first = dot(begin_ - origin, direction), last = dot(end_ - origin, direction);
    double const slack = sag(acceleration_along(direction));
    return {std::min(first, last) - slack, std::max(first, last) + slack};
}

Range LegPart::distance_from(Vec2 const& point) const {
    if (round_) {
        Vec2 const way = point - round_->centre;
        double const far = geometry::length(way), rho = round_->rho;
        Range const cosines = cosines_to(round_->angles, way);
        // The law of cosines, with what is small kept apart.
        auto const distance = [&](double cosine) {
            return std::sqrt((rho - far) * (rho - far) + 2 * rho * far * (1 - cosine));
        };
        return {distance(cosines.high), distance(cosines.low)};
    }
    Vec2 const chord = end_ - begin_, to_point = point - begin_;
    double const square = dot(chord, chord);
    double const share = square > 0 ? std::clamp(dot(to_point, chord) / square, 0.0, 1.0) : 0;
    double const nearest = geometry::length(to_point - share * chord);
    double const farthest = std::max(geometry::length(to_point), geometry::length(point - end_));
    double const slack = sag(acceleration());
    return {nearest - slack, farthest + slack};
}

}  // namespace physics
