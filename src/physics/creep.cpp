// Creeping: how a ball goes on where events stall.
#include <algorithm>
#include <cmath>
#include <optional>

#include "physics/contacts_at.h"
#include "physics/course_track.h"
#include "physics/ride.h"

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
constexpr double least_slip = 1e-9;   // m/s
constexpr double creep_grip = 1e-9;

// What is left of a velocity or an acceleration where no support lets it in; nothing where they leave no way.
Vec2 let_through(std::vector<Support> const& supports, Vec2 vector) {
    double const rounding = still_closing * geometry::length(vector);
    for (int round = 0; round < creep_rounds; ++round) {
        Support const* worst = nullptr;
        for (Support const& s : supports)
            if (dot(vector, s.normal) < (worst ? dot(vector, worst->normal) : -rounding)) worst = &s;
        if (worst == nullptr) return vector;
        vector -= dot(vector, worst->normal) * worst->normal;
    }
    return Vec2::Zero();
}

// Along the one surface that presses, rolling, or slipping on as it does, whatever the limit of grip says within rounding.
std::optional<Turnout> on_one(Setting const& setting, Support const& support, State const& state, double time) {
    Rider rider;
    rider.contact = support.contact;
    if (!fits(setting.terrain, rider.contact, setting.ball.radius)) return std::nullopt;
    rider.track = track_of(setting.terrain, rider.contact, setting.ball.radius);
    rider.q = nearest_coordinate(rider.track, state.position);
    rider.speed = dot(state.velocity, geometry::turned_right(support.normal));
    rider.rim = -setting.ball.radius * state.spin;
    rider.angle = state.angle;
    if (!is_pressed(setting, rider)) return std::nullopt;
    rider = held_by_full_grip(setting, rider);
    Law law;
    law.alpha = 1 / (1 + setting.ball.inertia);
    bool const slips = std::abs(rider.slip()) > creep_grip * (std::abs(rider.speed) + std::abs(rider.rim)) + least_slip;
    if (slips)
        law = law_for(setting, rider, Onset::none);
    else
        rider.rim = rider.speed;
    if (law.phase == Phase::rest) return std::nullopt;
    Turnout turnout;
    turnout.ends = ends_of_track(setting.terrain, rider.contact, rider.track, rider.q, setting.ball.radius);
    turnout.course = track_course(setting, rider, law, turnout.ends, time);
    Course& course = turnout.course;
    if (course.duration < shortest_creep) return std::nullopt;
    if (course.duration <= longest_creep) return turnout;
    course.duration = longest_creep;
    course.leg.until = time + course.duration;
    course.ending = Ending::goes_on;
    course.onset = Onset::none;
    return turnout;
}

// How long a straight creep strays from its curved surfaces, and from the pull's changes, by no more than creep_stray.
double span_of(Setting const& setting, std::vector<Support> const& supports, double speed, double pull) {
    double curvature = 0;
    for (Support const& s : supports) curvature = std::max(curvature, std::abs(s.curvature));
    geometry::Oscillator const& spring = setting.field.spring;
    auto const stray = [&](double span) {
        double const fastest = speed + pull * span;
        double const changes = (spring.stiffness * fastest + 2 * spring.decay * pull) * span;
        return 0.5 * span * span * (curvature * fastest * fastest + changes);
    };
    double span = longest_creep;
    while (span > shortest_creep && stray(span) > creep_stray) span /= 2;
    return std::max(span, shortest_creep);
}

}  // namespace

Turnout creeping(Setting const& setting, State const& state, double time) {
    std::vector<Support> const supports = contacts_at(setting.terrain, state.position, setting.ball.radius);
    State start = state;
    Vec2 const field = acceleration_in(setting.field, state.position, state.velocity);
    start.velocity = let_through(supports, state.velocity);
    if (geometry::length(start.velocity) <= least_slip) start.velocity = Vec2::Zero();
    Vec2 pull = let_through(supports, acceleration_in(setting.field, state.position, start.velocity));
    if (geometry::length(pull) <= balanced * geometry::length(field)) pull = Vec2::Zero();
    std::vector<Support> const apart = kept_apart(supports, start.velocity, field, least_slip);
    bool const moves = start.velocity != Vec2::Zero() || pull != Vec2::Zero();
    if (moves && apart.size() == 1)
        if (auto const on = on_one(setting, apart.front(), start, time)) return *on;
    Turnout turnout;
    Contact const contact = supports.empty() ? no_contact : supports.front().contact;
    if (start.velocity == Vec2::Zero() && pull == Vec2::Zero()) {
        start.spin = 0;
        turnout.course = standing_course(start, contact, 0, time);
        return turnout;
    }
    double const span = span_of(setting, supports, geometry::length(start.velocity), geometry::length(pull));
    Course& course = turnout.course;
    course.leg.since = time;
    course.leg.motion = Ballistic{start, pull, 0};
    Obstacle const found = first_contact(setting.terrain, {start.position, start.velocity, pull}, setting.ball.radius, span);
    course.duration = found.time > shortest_creep ? std::min(span, found.time) : shortest_creep;
    course.leg.until = time + course.duration;
    course.ending = Ending::meets;
    course.next = found.time <= course.duration ? found.contact : contact;
    return turnout;
}

Turnout jammed(State const& state, Contact contact, double time) {
    State still = state;
    still.velocity = Vec2::Zero();
    still.spin = 0;
    Turnout turnout;
    turnout.course = standing_course(still, contact, 0, time);
    turnout.happenings.push_back({EventKind::rest, contact});
    return turnout;
}

}  // namespace physics
