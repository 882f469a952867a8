// A ball that keeps to several points of terrain: held between them, led away by one, or passing through.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "physics/plan/plan_track.h"
#include "physics/plan/struck.h"

namespace physics {

using geometry::dot;

namespace {

// Of a pull, the share against which a further contact bars the way: those of the ends of one wall differ by less.
constexpr double barring = 1e-3;
// Normals nearer than this to opposite do not hold what lies between them.
constexpr double opposite_normals = 4e-9;
// Walls whose curvatures, times the ball's radius, differ by less are the two sides of one slot.
constexpr double same_bend = 1e-6;

// The normal forces with which two supports hold a standing ball whose rim slides with `slip_sign` (0: it does not).
struct TwoForces {
    double first = 0, second = 0;
};
TwoForces hold_of(MotionContext const& context, State const& state, ContactPoint const& a, ContactPoint const& b,
                  double slip_sign) {
    auto const push = [&](ContactPoint const& s) {
        double const friction =
            slip_sign == 0 ? 0 : material_of(context.terrain, s.contact.feature).friction * slip_sign;
        return Vec2(s.normal - friction * geometry::turned_right(s.normal));
    };
    Vec2 const p = push(a), q = push(b), load = -acceleration_in(context.field, state.position, Vec2::Zero());
    double const span = geometry::cross(p, q);
    return {geometry::cross(load, q) / span, geometry::cross(p, load) / span};
}

// Neither support would have to pull: a force that is rounding is none.
bool holds(MotionContext const& context, State const& state, TwoForces const& hold) {
    double const least =
        -hold_rounding * geometry::length(acceleration_in(context.field, state.position, Vec2::Zero()));
    return hold.first >= least && hold.second >= least;
}

}  // namespace

std::optional<Transition> wedged(MotionContext const& context, Struck const& struck,
                                 std::vector<std::size_t> const& kept, double time) {
    double const rim = -context.ball.radius * struck.state.spin;
    bool const spins = std::abs(rim) > struck.rounding;
    double const slip_sign = !spins ? 0 : rim < 0 ? 1 : -1;
    auto const friction_at = [&](ContactPoint const& point) {
        return material_of(context.terrain, point.contact.feature).friction;
    };
    State still = struck.state;
    still.velocity = Vec2::Zero();
    // At rest where it is held, or spinning against this friction, a force per mass; infinite: grip ends it at once.
    auto const held = [&](Contact contact, double friction) {
        State state = still;
        if (std::isinf(friction) || !spins) state.spin = 0;
        double const rim_rate = state.spin == 0 ? 0 : slip_sign * friction / context.ball.inertia;
        Transition transition;
        transition.plan = plan_standing(state, contact, -rim_rate / context.ball.radius, time);
        if (state.spin == 0) transition.contact_events.push_back({EventKind::rest, contact});
        return transition;
    };
    Vec2 const load = -acceleration_in(context.field, still.position, still.velocity);
    for (std::size_t const i : kept) {
        ContactPoint const& socket = struck.points[i];
        bool const bears =
            socket.normals_turn != 0 && dot(load, socket.normal) >= (1 - parallel) * geometry::length(load);
        double const force = geometry::length(load);
        if (bears) return held(socket.contact, force > 0 ? friction_at(socket) * force : 0);
    }
    for (std::size_t i = 0; i < kept.size(); ++i) {
        for (std::size_t j = i + 1; j < kept.size(); ++j) {
            ContactPoint const& a = struck.points[kept[i]];
            ContactPoint const& b = struck.points[kept[j]];
            if (std::abs(geometry::cross(a.normal, b.normal)) < parallel) continue;
            double const mu_a = friction_at(a), mu_b = friction_at(b);
            bool const grips_fully = std::isinf(mu_a) || std::isinf(mu_b);
            TwoForces hold = hold_of(context, still, a, b, grips_fully ? 0 : slip_sign);
            // Forces along one line with their friction balance no load: they grow until the spin has ended.
            bool const locks = !std::isfinite(hold.first) || !std::isfinite(hold.second);
            if (locks) hold = hold_of(context, still, a, b, 0);
            if (!holds(context, still, hold)) continue;
            if (grips_fully || locks) return held(a.contact, std::numeric_limits<double>::infinity());
            // What holds by rounding alone does not rub.
            return held(a.contact, mu_a * std::max(0.0, hold.first) + mu_b * std::max(0.0, hold.second));
        }
    }
    return std::nullopt;
}

namespace {

bool presses(MotionContext const& context, Struck const& struck, std::size_t i) {
    ContactPoint const& point = struck.points[i];
    if (fits(context.terrain, point.contact, context.ball.radius))
        return is_pressed(context, surface_state_on(context, struck, i));
    Vec2 const pull = acceleration_in(context.field, struck.state.position, struck.state.velocity);
    return dot(pull, point.normal) < -hold_rounding * geometry::length(pull);
}

}  // namespace

Transition stuck(MotionContext const& context, Struck const& struck, std::vector<std::size_t> const& kept,
                 double time) {
    Transition transition;
    State state = struck.state;
    for (std::size_t const i : kept) {
        if (!presses(context, struck, i)) continue;
        state.velocity = Vec2::Zero();
        state.spin = 0;
        transition.plan = plan_standing(state, struck.points[i].contact, 0, time);
        transition.contact_events.push_back({EventKind::rest, struck.points[i].contact});
        return transition;
    }
    transition.plan = plan_flight(context, state, time);
    return transition;
}

namespace {

// Along the support that leads a ball away from the others that it keeps to, if there is one.
std::optional<Transition> way_out(MotionContext const& context, Struck const& struck,
                                  std::vector<std::size_t> const& kept, double time) {
    for (std::size_t const i : kept) {
        if (!fits(context.terrain, struck.points[i].contact, context.ball.radius)) continue;
        SurfaceState const on_track = surface_state_on(context, struck, i);
        if (!is_pressed(context, on_track)) continue;
        double const force = normal_force(context, on_track);
        ContactMode const mode = contact_mode_for(context, on_track, ModeHint::none);
        double const a =
            mode.phase == Phase::rest ? 0 : mode.alpha * tangent_acceleration(context, on_track) + mode.beta * force;
        Vec2 const way = (on_track.speed != 0 ? on_track.speed : a) * geometry::turned_right(struck.points[i].normal);
        bool free = true;
        for (std::size_t const j : kept)
            free = free && (j == i || dot(way, struck.points[j].normal) >= -parallel * geometry::length(way));
        if (free) return ride_from(context, on_track, time);
    }
    return std::nullopt;
}

// Two surfaces that are not parallel leave a ball that keeps to both no way to move.
bool pins(Struck const& struck, std::vector<std::size_t> const& kept) {
    for (std::size_t const i : kept)
        for (std::size_t const j : kept)
            if (std::abs(geometry::cross(struck.points[i].normal, struck.points[j].normal)) >= parallel) return true;
    return false;
}

}  // namespace

bool stands_among_several(MotionContext const& context, Struck const& struck) {
    std::vector<std::size_t> all(struck.points.size());
    std::iota(all.begin(), all.end(), 0);
    double const pull = geometry::length(acceleration_in(context.field, struck.state.position, struck.state.velocity));
    double const height = context.crowded ? touch_reach : 4 * lowest_hop * context.ball.radius;
    double const speed = geometry::length(struck.state.velocity);
    return all.size() > 1 && speed * speed <= 2 * pull * height && pins(struck, all);
}

namespace {

// Along two straight walls as far apart as the ball is wide, neither of which presses on it.
std::optional<Transition> between_walls(MotionContext const& context, Struck const& struck, std::size_t i,
                                        std::size_t j, double time) {
    SurfaceState const on_track = surface_state_on(context, struck, i);
    if (!on_track.track.straight || struck.points[j].curvature != 0 || is_pressed(context, on_track) ||
        is_pressed(context, surface_state_on(context, struck, j)))
        return std::nullopt;
    ContactMode mode;
    mode.phase = Phase::slide;
    Transition transition;
    transition.track_ends =
        ends_of_track(context.terrain, on_track.contact, on_track.track, on_track.q, context.ball.radius);
    transition.plan = plan_track(context, on_track, mode, transition.track_ends, time);
    return transition;
}

// Between two points as far apart as the ball is wide, within touch, it is held by rounding alone: it passes them. By
// two surfaces that face each other it may be held no better.
std::optional<Transition> passing(MotionContext const& context, Struck const& struck,
                                  std::vector<std::size_t> const& kept, double time) {
    double const radius = context.ball.radius;
    Vec2 const load = acceleration_in(context.field, struck.state.position, Vec2::Zero());
    auto const faces = [&](std::size_t i, std::size_t j) {
        Vec2 const sum = struck.points[i].normal + struck.points[j].normal;
        bool const points = context.terrain.is_vertex(struck.points[i].contact.feature) &&
                            context.terrain.is_vertex(struck.points[j].contact.feature);
        double const nearest = points ? std::sqrt(8 * touch_reach / radius) : opposite_normals;
        return geometry::length(sum) <= nearest;
    };
    for (std::size_t const i : kept) {
        if (!fits(context.terrain, struck.points[i].contact, radius)) return std::nullopt;
        for (std::size_t const j : kept) {
            if (i >= j || !faces(i, j)) continue;
            Vec2 const normal = struck.points[i].normal - struck.points[j].normal;
            Vec2 const along = load - (dot(load, normal) / dot(normal, normal)) * normal;
            double const pull = geometry::length(along);
            if (!(pull > hold_rounding * geometry::length(load))) continue;
            bool const barred = std::any_of(struck.points.begin(), struck.points.end(), [&](ContactPoint const& s) {
                return &s != &struck.points[i] && &s != &struck.points[j] && dot(along, s.normal) < -barring * pull;
            });
            if (barred) continue;
            if (auto const on = between_walls(context, struck, i, j, time)) return *on;
            double const bend = struck.points[i].curvature + struck.points[j].curvature;
            bool const is_slot = radius * std::abs(bend) <= same_bend;
            if (auto const on = is_slot ? way_out(context, struck, kept, time) : std::nullopt) return *on;
            Vec2 const sum = struck.points[i].normal + struck.points[j].normal;
            double const way = radius * geometry::length(sum) / 2 + touch_reach / 8;
            Transition transition;
            transition.plan.leg.since = time;
            State state = struck.state;
            double const speed = std::max(0.0, dot(state.velocity, along) / pull);
            state.velocity = speed / pull * along;
            transition.plan.leg.motion = Ballistic{state, along, 0};
            transition.plan.end.time = 2 * way / (speed + std::sqrt(speed * speed + 2 * pull * way));
            transition.plan.leg.until = time + transition.plan.end.time;
            transition.plan.end.cause = LegEndCause::meets;
            return transition;
        }
    }
    return std::nullopt;
}

}  // namespace

Transition among_several(MotionContext const& context, Struck& struck, std::vector<std::size_t> const& kept,
                         double time) {
    if (struck.state.velocity != Vec2::Zero())
        if (auto const on = way_out(context, struck, kept, time)) return *on;
    if (pins(struck, kept)) struck.state.velocity = Vec2::Zero();
    if (auto const on = passing(context, struck, kept, time)) return *on;
    if (auto const held = wedged(context, struck, kept, time)) return *held;
    if (auto const on = way_out(context, struck, kept, time)) return *on;
    return stuck(context, struck, kept, time);
}

}  // namespace physics
