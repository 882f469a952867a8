// Creeping: how a ball goes on where events stall.
#include <algorithm>
#include <cmath>
#include <optional>

#include "physics/contact/contacts_at.h"
#include "physics/plan/plan_track.h"
#include "physics/plan/transition.h"

namespace physics {

using geometry::dot;

namespace {

constexpr int creep_rounds = 100;
constexpr double shortest_creep = 1e-7;  // s
constexpr double longest_creep = 1e-3;   // s
// Components below this share of the vector are rounding.
constexpr double still_closing = 1e-12;
// A pull that supports leave over of the field, below this share of it, is none, nor are these speeds.
constexpr double balanced = 1e-9;
constexpr double least_slip = 1e-9;  // m/s
constexpr double creep_grip = 1e-9;

// What is left of a velocity or an acceleration where no support lets it in; nothing where they leave no way.
Vec2 let_through(std::vector<ContactPoint> const& points, Vec2 vector) {
    double const rounding = still_closing * geometry::length(vector);
    for (int round = 0; round < creep_rounds; ++round) {
        ContactPoint const* worst = nullptr;
        for (ContactPoint const& s : points)
            if (dot(vector, s.normal) < (worst ? dot(vector, worst->normal) : -rounding)) worst = &s;
        if (worst == nullptr) return vector;
        vector -= dot(vector, worst->normal) * worst->normal;
    }
    return Vec2::Zero();
}

// Along the one surface that presses, rolling, or slipping on as it does, whatever the limit of grip says within
// rounding.
std::optional<Transition> on_one(MotionContext const& context, ContactPoint const& point, State const& state,
                                 double time) {
    SurfaceState on_track;
    on_track.contact = point.contact;
    if (!fits(context.terrain, on_track.contact, context.ball.radius)) return std::nullopt;
    on_track.track = track_of(context.terrain, on_track.contact, context.ball.radius);
    on_track.q = nearest_coordinate(on_track.track, state.position);
    on_track.speed = dot(state.velocity, geometry::turned_right(point.normal));
    on_track.rim = -context.ball.radius * state.spin;
    on_track.angle = state.angle;
    if (!is_pressed(context, on_track)) return std::nullopt;
    on_track = held_by_full_grip(context, on_track);
    ContactMode mode;
    mode.alpha = 1 / (1 + context.ball.inertia);
    bool const slips =
        std::abs(on_track.slip()) > creep_grip * (std::abs(on_track.speed) + std::abs(on_track.rim)) + least_slip;
    if (slips)
        mode = contact_mode_for(context, on_track, ModeHint::none);
    else
        on_track.rim = on_track.speed;
    if (mode.phase == Phase::rest) return std::nullopt;
    Transition transition;
    transition.track_ends =
        ends_of_track(context.terrain, on_track.contact, on_track.track, on_track.q, context.ball.radius);
    transition.plan = plan_track(context, on_track, mode, transition.track_ends, time);
    LegPlan& plan = transition.plan;
    if (plan.end.time < shortest_creep) return std::nullopt;
    if (plan.end.time <= longest_creep) return transition;
    plan.end.time = longest_creep;
    plan.leg.until = time + plan.end.time;
    plan.end.cause = LegEndCause::goes_on;
    plan.end.hint = ModeHint::none;
    return transition;
}

// How long a straight creep strays from its curved surfaces, and from the pull's changes, by no more than creep_stray.
double span_of(MotionContext const& context, std::vector<ContactPoint> const& points, double speed, double pull) {
    double curvature = 0;
    for (ContactPoint const& s : points) curvature = std::max(curvature, std::abs(s.curvature));
    geometry::Oscillator const& spring = context.field.spring;
    auto const stray = [&](double span) {
        double const fastest = speed + pull * span;
        double const changes = (spring.stiffness * fastest + 2 * spring.decay * pull) * span;
        return 0.5 * span * span * (curvature * fastest * fastest + changes);
    };
    double span = longest_creep;
    while (span > shortest_creep && stray(span) > creep_stray) span /= 2;
    return std::max(span, shortest_creep);
}

// How long, of `span`, a creeping ball takes to the nearest end of what it touches.
double span_to_end(MotionContext const& context, std::vector<ContactPoint> const& points, State const& start, Vec2 pull,
                   double span) {
    for (ContactPoint const& s : points) {
        if (!fits(context.terrain, s.contact, context.ball.radius)) continue;
        Track const track = track_of(context.terrain, s.contact, context.ball.radius);
        if (track.closed) continue;
        Vec2 const along = geometry::turned_right(s.normal);
        double const q = nearest_coordinate(track, start.position), speed = dot(start.velocity, along);
        double const left = speed > 0 || (speed == 0 && dot(pull, along) > 0) ? track.length - q : q;
        double const fastest = std::abs(speed) + std::abs(dot(pull, along)) * span;
        if (left > touch_reach && fastest * span > left) span = left / fastest;
    }
    return std::max(span, shortest_creep);
}

}  // namespace

Transition creeping(MotionContext const& context, State const& state, double time) {
    std::vector<ContactPoint> const points = contacts_at(context.terrain, state.position, context.ball.radius);
    State start = state;
    Vec2 const field = acceleration_in(context.field, state.position, state.velocity);
    start.velocity = let_through(points, state.velocity);
    if (geometry::length(start.velocity) <= least_slip) start.velocity = Vec2::Zero();
    std::vector<ContactPoint> kept = points;  // not what it parts from
    std::erase_if(kept, [&](ContactPoint const& s) {
        return dot(start.velocity, s.normal) > balanced * geometry::length(start.velocity) + least_slip;
    });
    Vec2 pull = let_through(kept, acceleration_in(context.field, state.position, start.velocity));
    if (geometry::length(pull) <= balanced * geometry::length(field)) pull = Vec2::Zero();
    std::vector<ContactPoint> const apart = kept_apart(points, start.velocity, field, least_slip);
    bool const moves = start.velocity != Vec2::Zero() || pull != Vec2::Zero();
    if (moves && apart.size() == 1)
        if (auto const on = on_one(context, apart.front(), start, time)) return *on;
    Transition transition;
    Contact const contact = points.empty() ? no_contact : points.front().contact;
    if (start.velocity == Vec2::Zero() && pull == Vec2::Zero()) {
        start.spin = 0;
        transition.plan = plan_standing(start, contact, 0, time);
        return transition;
    }
    double const straight = span_of(context, points, geometry::length(start.velocity), geometry::length(pull));
    double const span = span_to_end(context, points, start, pull, straight);
    LegPlan& plan = transition.plan;
    plan.leg.since = time;
    plan.leg.motion = Ballistic{start, pull, 0};
    SweepHit const found =
        first_contact(context.terrain, {start.position, start.velocity, pull}, context.ball.radius, span);
    plan.end.time = found.time > shortest_creep ? std::min(span, found.time) : shortest_creep;
    plan.leg.until = time + plan.end.time;
    plan.end.cause = LegEndCause::meets;
    plan.end.next = found.time <= plan.end.time ? found.contact : contact;
    return transition;
}

Transition jammed(State const& state, Contact contact, double time) {
    State still = state;
    still.velocity = Vec2::Zero();
    still.spin = 0;
    Transition transition;
    transition.plan = plan_standing(still, contact, 0, time);
    transition.contact_events.push_back({EventKind::rest, contact});
    return transition;
}

}  // namespace physics
