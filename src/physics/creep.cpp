// Creeping: how a ball goes on where events stall.
#include <algorithm>
#include <cmath>

#include "physics/contacts_at.h"
#include "physics/ride.h"

namespace physics {

using geometry::dot;

namespace {

constexpr int most_rounds = 100;
constexpr double shortest_creep = 1e-7;  // s
constexpr double longest_creep = 1e-4;   // s
// Components below this share of the vector are rounding.
constexpr double still_closing = 1e-12;

// What is left of a velocity or an acceleration where no support lets it in; nothing where they leave no way.
Vec2 let_through(std::vector<Support> const& supports, Vec2 vector) {
    double const rounding = still_closing * geometry::length(vector);
    for (int round = 0; round < most_rounds; ++round) {
        Support const* worst = nullptr;
        for (Support const& s : supports)
            if (dot(vector, s.normal) < (worst ? dot(vector, worst->normal) : -rounding)) worst = &s;
        if (worst == nullptr) return vector;
        vector -= dot(vector, worst->normal) * worst->normal;
    }
    return Vec2::Zero();
}

}  // namespace

Turnout creeping(Setting const& setting, State const& state, double time) {
    std::vector<Support> const supports = contacts_at(setting.terrain, state.position, setting.ball.radius);
    State start = state;
    start.velocity = let_through(supports, state.velocity);
    Vec2 const pull = let_through(supports, acceleration_in(setting.field, state.position, start.velocity));
    Turnout turnout;
    Contact const contact = supports.empty() ? no_contact : supports.front().contact;
    if (start.velocity == Vec2::Zero() && pull == Vec2::Zero()) {
        start.spin = 0;
        turnout.course = standing_course(start, contact, 0, time);
        return turnout;
    }
    double bend = geometry::length(pull) / setting.ball.radius;
    for (Support const& s : supports)
        bend = std::max(bend, std::abs(s.curvature) * dot(start.velocity, start.velocity));
    bend += setting.field.spring.stiffness * geometry::length(start.velocity) * longest_creep +
            2 * setting.field.spring.decay * geometry::length(pull) * longest_creep;
    double const span =
        std::clamp(std::sqrt(2 * creep_stray / std::max(bend, 1e-300)), shortest_creep, longest_creep);
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

}  // namespace physics
