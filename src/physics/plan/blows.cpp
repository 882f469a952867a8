// Impacts of a ball with all the points of terrain that it closes on.
#include <algorithm>
#include <cmath>

#include "physics/motion/impact.h"
#include "physics/plan/struck.h"

namespace physics {

using geometry::dot;

ContactSpeeds speeds_at(MotionContext const& context, State const& state, Vec2 const& normal) {
    return {dot(state.velocity, normal), dot(state.velocity, geometry::turned_right(normal)),
            -context.ball.radius * state.spin};
}

namespace {

// Speeds along a normal below this share of the ball's speeds are rounding.
constexpr double resolve_rounding = 1e-12;
// Blows in one moment; between two walls that meet at a narrow angle they die out like a geometric series. Across a
// socket, which is touched all round, they go to and fro as if it had no play.
constexpr int most_blows = 200, most_blows_in_socket = 20;
// Closing speeds that differ by less than this share are equal.
constexpr double equal_speeds = 1e-9;
// What the caller knows to be touched lies within this of the ball's way, in m, or its place is another.
constexpr double known_reach = 1e-6;

void set_speeds(MotionContext const& context, State& state, Vec2 const& normal, ContactSpeeds const& speeds) {
    state.velocity = speeds.normal * normal + speeds.tangent * geometry::turned_right(normal);
    state.spin = -speeds.rim / context.ball.radius;
}

void note_blow(Struck& struck, EventKind kind, Contact contact) {
    for (Transition::ContactEvent const& blow : struck.blows)
        if (blow.contact == contact && blow.kind == kind) return;
    struck.blows.push_back({kind, contact});
}

void strike(MotionContext const& context, Struck& struck, std::size_t i) {
    ContactPoint const& point = struck.points[i];
    Material const& material = material_of(context.terrain, point.contact.feature);
    ContactSpeeds const before = speeds_at(context, struck.state, point.normal);
    double const restitution = context.crowded ? 0 : material.restitution;
    ContactSpeeds const after = after_impact(before, restitution, material.friction, context.ball.inertia);
    set_speeds(context, struck.state, point.normal, after);
    struck.gripped = after.slip() == 0 ? std::optional(point.normal) : std::nullopt;
    note_blow(struck, after.normal > 0 ? EventKind::bounce : EventKind::land, point.contact);
}

// Friction of at most `limit` (m/s) against the slip at a contact.
void rub(MotionContext const& context, State& state, Vec2 const& normal, double limit) {
    double const k = context.ball.inertia;
    ContactSpeeds speeds = speeds_at(context, state, normal);
    double const impulse = std::clamp(-speeds.slip() * k / (1 + k), -limit, limit);
    speeds.tangent += impulse;
    speeds.rim -= impulse / k;
    set_speeds(context, state, normal, speeds);
}

// The supports that the ball closes on, fastest first. Of those that rounding alone would tell from the fastest the
// first is the one that counts first.
std::vector<std::size_t> closing_supports(MotionContext const& context, Struck const& struck) {
    std::vector<std::size_t> closing;
    auto const speed = [&](std::size_t i) { return dot(struck.state.velocity, struck.points[i].normal); };
    Vec2 const pull = acceleration_in(context.field, struck.state.position, struck.state.velocity);
    double const least = least_dip(struck.state.position);
    for (std::size_t i = 0; i < struck.points.size(); ++i)
        if (speed(i) < -struck.still &&
            dip_of(speed(i), second_derivative(struck.points[i], struck.state.velocity, pull)) > least)
            closing.push_back(i);
    double fastest = 0;
    for (std::size_t const i : closing) fastest = std::min(fastest, speed(i));
    auto const rank = [&](std::size_t i) { return speed(i) <= (1 - equal_speeds) * fastest ? fastest : speed(i); };
    std::stable_sort(closing.begin(), closing.end(), [&](std::size_t i, std::size_t j) { return rank(i) < rank(j); });
    return closing;
}

// Two supports that the ball closes on at once push together, so that neither is the first: a ball that falls into the
// middle of a groove stays there (physics.md 7.1). False when that would take a pull.
bool strike_both(MotionContext const& context, Struck& struck, std::size_t i, std::size_t j) {
    ContactPoint const& a = struck.points[i];
    ContactPoint const& b = struck.points[j];
    Material const& of_a = material_of(context.terrain, a.contact.feature);
    Material const& of_b = material_of(context.terrain, b.contact.feature);
    double const sine = geometry::cross(a.normal, b.normal);
    if (sine * sine < parallel) return false;
    double const e_a = context.crowded ? 0 : of_a.restitution, e_b = context.crowded ? 0 : of_b.restitution;
    Vec2 const before = struck.state.velocity;
    // By the speeds along both normals that it has afterwards: where they are nearly opposite the pushes are far
    // greater.
    double const along_a = -e_a * dot(before, a.normal), along_b = -e_b * dot(before, b.normal);
    Vec2 const after = (along_a * geometry::turned_right(b.normal) - along_b * geometry::turned_right(a.normal)) / sine;
    double const push_a = geometry::cross(Vec2(after - before), b.normal) / sine;
    double const push_b = geometry::cross(a.normal, Vec2(after - before)) / sine;
    if (push_a < 0 || push_b < 0) return false;
    struck.state.velocity = after;
    // Neither rubs first: the mean of both orders, which has no more energy than they.
    State a_first = struck.state, b_first = struck.state;
    rub(context, a_first, a.normal, of_a.friction * push_a);
    rub(context, a_first, b.normal, of_b.friction * push_b);
    rub(context, b_first, b.normal, of_b.friction * push_b);
    rub(context, b_first, a.normal, of_a.friction * push_a);
    struck.state.velocity = (a_first.velocity + b_first.velocity) / 2;
    struck.state.spin = (a_first.spin + b_first.spin) / 2;
    note_blow(struck, e_a > 0 ? EventKind::bounce : EventKind::land, a.contact);
    note_blow(struck, e_b > 0 ? EventKind::bounce : EventKind::land, b.contact);
    struck.gripped.reset();
    return true;
}

// Whether rounding alone tells which of two supports the ball closes on faster.
bool are_equal(Struck const& struck, std::size_t i, std::size_t j) {
    double const a = dot(struck.state.velocity, struck.points[i].normal);
    double const b = dot(struck.state.velocity, struck.points[j].normal);
    return std::abs(a - b) <= equal_speeds * std::abs(a);
}

}  // namespace

void choose_supports(MotionContext const& context, Struck& struck) {
    Vec2 const pull = acceleration_in(context.field, struck.state.position, struck.state.velocity);
    struck.points = kept_apart(struck.touched, struck.state.velocity, pull, struck.rounding);
}

void strike_all(MotionContext const& context, Struck& struck) {
    bool const in_socket = std::any_of(struck.touched.begin(), struck.touched.end(),
                                       [](ContactPoint const& s) { return s.normals_turn != 0; });
    int const most = in_socket ? most_blows_in_socket : most_blows;
    for (int blow = 0;; ++blow) {
        // A socket pushes against the velocity there is.
        if (in_socket && blow > 0) choose_supports(context, struck);
        std::vector<std::size_t> const closing = closing_supports(context, struck);
        if (closing.empty()) return;
        if (blow == most) break;
        if (closing.size() > 1 && (closing.size() == 2 || are_equal(struck, closing[0], closing[1])) &&
            strike_both(context, struck, closing[0], closing[1]))
            continue;
        strike(context, struck, closing.front());
    }
    // To and fro between two walls that face each other it is only across them that it stands.
    Vec2 const normal = struck.points[closing_supports(context, struck).front()].normal;
    struck.state.velocity -= dot(struck.state.velocity, normal) * normal;
    if (!closing_supports(context, struck).empty()) struck.state.velocity = Vec2::Zero();
}

Struck struck_at(MotionContext const& context, State const& state, Contact known) {
    double const pull = geometry::length(acceleration_in(context.field, state.position, state.velocity));
    double const rounding =
        resolve_rounding * (geometry::length(state.velocity) + context.ball.radius * std::abs(state.spin) +
                            std::sqrt(pull * context.ball.radius));
    double const still = still_speed(state.position, context.ball.radius, geometry::length(state.velocity), pull);
    Struck struck{
        state,       contacts_at(context.terrain, state.position, context.ball.radius), {}, known, {}, still, rounding,
        std::nullopt};
    bool const found = std::any_of(struck.touched.begin(), struck.touched.end(),
                                   [&](ContactPoint const& s) { return s.contact == known; });
    if (known.feature >= 0 && !found && fits(context.terrain, known, context.ball.radius)) {
        Track const track = track_of(context.terrain, known, context.ball.radius);
        double const q = nearest_coordinate(track, state.position);
        if (geometry::length(position_at(track, q) - state.position) < known_reach)
            struck.touched.push_back({known, normal_at(track, q), 0, track.straight ? 0 : track.sense / track.rho});
    }
    choose_supports(context, struck);
    // What rounding has left of a depth must not add up over many bounces.
    for (ContactPoint const& s : struck.points)
        if (s.gap < -least_depth && s.gap >= -8 * touch_reach) struck.state.position -= s.gap * s.normal;
    return struck;
}

}  // namespace physics
