#include "hunt/witness.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hunt {

using geometry::dot;
using geometry::length;
using geometry::cross;

namespace {

constexpr double no_limit = 1e300;
constexpr double longest_look = 0.97 / 240;      // s, in no step with anything
constexpr double shortest_look = 1e-9;           // s
constexpr double after_events[] = {1e-6, 1e-4};  // s

// What pulls at the ball where it is.
Vec2 acceleration_on(Sketch const& sketch, physics::Forces const& forces, physics::State const& state) {
    Vec2 pull(sketch.gravity * std::sin(forces.tilt), -sketch.gravity * std::cos(forces.tilt));
    if (!forces.pull) return pull;
    double const omega = 2 * std::numbers::pi * sketch.drag_frequency;
    return pull + omega * omega * (forces.pull->target - state.position) -
           2 * sketch.drag_damping * omega * state.velocity;
}

// Whether forces at the feet can hold a ball still against `pull`: friction cones that hold its opposite between them,
// or one foot and the couple against rolling (physics.md 4.3, 7.2).
bool is_held(Ground const& ground, std::vector<Foot> const& feet, Vec2 const& centre, Vec2 const& pull) {
    constexpr double rounding = 1e-6;
    double const size = length(pull);
    if (size < rounding) return true;
    std::vector<Vec2> edges;
    for (Foot const& foot : feet) {
        Vec2 const normal = (centre - foot.point) / length(centre - foot.point);
        Limb const& limb = ground[static_cast<std::size_t>(foot.limb)];
        double const pressed = -dot(pull, normal), aside = std::abs(cross(pull, normal));
        if (aside <= std::min(limb.resistance, limb.friction) * pressed + rounding * size && pressed > 0) return true;
        Vec2 const tangent = geometry::turned_left(normal);
        bool const grips = std::isinf(limb.friction);
        edges.push_back(grips ? tangent : Vec2(normal + limb.friction * tangent));
        edges.push_back(grips ? Vec2(-tangent) : Vec2(normal - limb.friction * tangent));
        if (grips) edges.push_back(normal);
    }
    for (Vec2 const& a : edges)
        for (Vec2 const& b : edges) {
            double const area = cross(a, b);
            if (area <= 0) continue;
            double const of_a = cross(-pull, b), of_b = cross(a, -pull);
            if (of_a >= -rounding * size && of_b >= -rounding * size) return feet.size() > 1;
        }
    return false;
}

class Look {
public:
    Look(Sketch const& sketch, game::Session const& session, Limits const& limits, Findings& findings)
        : sketch_(sketch),
          session_(session),
          limits_(limits),
          findings_(findings),
          ball_(session.level->scene.balls[0]),
          read_(ground_of(session.level->scene.terrain)),
          drawn_(ground_of(sketch.elements)) {}

    void over(double end) {
        auto const& legs = session_.history.legs[0];
        for (std::size_t i = 0; i < legs.size() && legs[i].since < end; ++i) {
            bool const last = i + 1 == legs.size();
            double const until = last ? end : std::min(end, legs[i + 1].since);
            along(legs[i], until);
            if (last) return;
            Vec2 const here = physics::at(legs[i], legs[i + 1].since).position;
            double const gap = length(physics::at(legs[i + 1], legs[i + 1].since).position - here);
            // A joint may turn by as much as 1e-3 rad, over which the ball is carried at once, be it that it lifts there.
            double const carried = legs[i].contact.feature >= 0 ? 1e-3 * ball_.radius : 0;
            if (gap > limits_.jump * std::max(1.0, length(here)) + carried) findings_.note(Wrong::jump, gap, legs[i + 1].since);
        }
    }

private:
    // In order of time, as energy wants it.
    void along(physics::Leg const& leg, double until) {
        double const marks[] = {leg.since + after_events[0], leg.since + after_events[1], (leg.since + until) / 2};
        for (double time = leg.since; time < until;) {
            double next = time + std::max(at(leg, time), shortest_look);
            for (double const mark : marks)
                if (time < mark && mark < next) next = mark;
            time = next > time ? next : until;
        }
        // What acts may change here: whether the ball is held still is another leg's matter.
        physics::Leg ending = leg;
        if (ending.phase == physics::Phase::rest) ending.phase = physics::Phase::roll;
        at(ending, until);
    }

    // What is seen at a time; how long nothing can be missed, s.
    double at(physics::Leg const& leg, double time) {
        physics::State const state = physics::at(leg, time);
        if (!geometry::is_finite(state.position) || !geometry::is_finite(state.velocity) ||
            !std::isfinite(state.spin)) {
            findings_.note(Wrong::not_finite, 0, time);
            return longest_look;
        }
        double const distance = nearest_on(read_, state.position).distance;
        if (ball_.radius - distance > limits_.depth) findings_.note(Wrong::depth, ball_.radius - distance, time);
        double const as_drawn = nearest_on(drawn_, state.position).distance;
        if (ball_.radius - as_drawn > limits_.drawn) findings_.note(Wrong::drawn, ball_.radius - as_drawn, time);
        weigh(state, time);
        Vec2 const pull = acceleration_on(sketch_, game::forces_at(session_, time), state);
        if (leg.phase != physics::Phase::flight) stands(leg, state, distance, pull, time);
        if (leg.phase == physics::Phase::rest) return longest_look;
        // Half a radius of way shows a ball inside a line; ground far away is nearer than that to nothing.
        double const way = std::max(ball_.radius, distance - ball_.radius) / 2, speed = length(state.velocity);
        return std::min(longest_look, 2 * way / (speed + std::sqrt(speed * speed + 2 * length(pull) * way) + 1e-9));
    }

    void weigh(physics::State const& state, double time) {
        if (!sketch_.inputs.empty()) return;
        double const rim = ball_.radius * state.spin;
        double const motion = (dot(state.velocity, state.velocity) + ball_.inertia * rim * rim) / 2;
        double const height = sketch_.gravity * state.position.y();
        double const gained = (motion + height - least_) / std::max(1.0, motion + std::abs(height));
        if (gained > limits_.energy) findings_.note(Wrong::energy, gained, time);
        least_ = std::min(least_, motion + height);
    }

    void stands(physics::Leg const& leg, physics::State const& state, double distance, Vec2 const& pull, double time) {
        if (distance - ball_.radius > limits_.hover) findings_.note(Wrong::hover, distance - ball_.radius, time);
        if (leg.phase != physics::Phase::rest || limits_.hover == no_limit) return;
        auto const feet = feet_within(read_, state.position, ball_.radius + limits_.hover);
        // At the centre of an arc of the ball's own radius all of the arc is a foot.
        bool const in_a_socket = std::any_of(feet.begin(), feet.end(), [&](Foot const& foot) {
            Limb const& limb = read_[static_cast<std::size_t>(foot.limb)];
            return limb.round && length(limb.centre - state.position) <= 2 * limits_.hover;
        });
        if (!feet.empty() && !in_a_socket && !is_held(read_, feet, state.position, pull))
            findings_.note(Wrong::held, length(pull), time);
    }

    Sketch const& sketch_;
    game::Session const& session_;
    Limits const& limits_;
    Findings& findings_;
    physics::Ball const& ball_;
    Ground read_, drawn_;
    double least_ = no_limit;  // m^2/s^2, of the energy so far
};

}  // namespace

Limits limits_of(Sketch const& sketch, physics::Method const& method) {
    Limits limits;
    for (Element const& element : sketch.elements)
        for (Stroke const& stroke : element.strokes)
            if (std::holds_alternative<Cubic>(stroke) || std::holds_alternative<Quadratic>(stroke))
                limits.drawn = 3e-3;  // a millimetre of the reader's, the rest of our chords
    if (std::holds_alternative<physics::Exact>(method)) return limits;
    return {1e-3, limits.drawn + 1e-3, no_limit, no_limit, no_limit};
}

void Findings::note(Wrong wrong, double measured, double time, std::string const& words) {
    auto const known =
        std::find_if(findings_.begin(), findings_.end(), [=](Finding const& f) { return f.wrong == wrong; });
    if (known == findings_.end()) {
        findings_.push_back({wrong, measured, time, words});
    } else {
        known->measured = std::max(known->measured, measured);
    }
}

std::vector<Finding> Findings::by_weight() const {
    std::vector<Finding> sorted = findings_;
    std::sort(sorted.begin(), sorted.end(), [](Finding const& a, Finding const& b) { return a.wrong < b.wrong; });
    return sorted;
}

void look(Sketch const& sketch, game::Session const& session, double end, Limits const& limits, Findings& findings) {
    Look(sketch, session, limits, findings).over(end);
}

}  // namespace hunt
