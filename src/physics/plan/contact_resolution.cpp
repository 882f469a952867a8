// What becomes of a ball where it touches terrain: blows, then which contacts it keeps.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "physics/contact/contacts_at.h"
#include "physics/plan/plan_track.h"
#include "physics/motion/impact.h"
#include "physics/plan/transition.h"

namespace physics {

using geometry::dot;

namespace {

// Speeds along a normal below this share of the ball's speeds are rounding.
constexpr double resolve_rounding = 1e-12;
// Blows in one moment; between two walls that meet at a narrow angle they die out like a geometric series.
constexpr int most_blows = 200;
// Normals nearer than this to parallel leave a ball free to move along both surfaces.
constexpr double parallel = 1e-9;
// A depth up to here, in m, is the rounding of one bounce.
constexpr double least_depth = 1e-11;
// Closing speeds that differ by less than this share are equal.
constexpr double equal_speeds = 1e-9;
// Rounding of accelerations, times this, tells a gap that opens.
constexpr double parting = 1e3;
// Forces below this share of the field are rounding.
constexpr double hold_rounding = 1e-12;
// Of a pull, the share against which a further contact bars the way: those of the ends of one wall differ by less.
constexpr double barring = 1e-3;
// What the caller knows to be touched lies within this of the ball's way, in m, or its place is another.
constexpr double known_reach = 1e-6;
// Normals nearer than this to opposite do not hold what lies between them.
constexpr double opposite_normals = 4e-9;

ContactSpeeds speeds_at(MotionContext const& context, State const& state, Vec2 const& normal) {
    return {dot(state.velocity, normal), dot(state.velocity, geometry::turned_right(normal)),
            -context.ball.radius * state.spin};
}

void set_speeds(MotionContext const& context, State& state, Vec2 const& normal, ContactSpeeds const& speeds) {
    state.velocity = speeds.normal * normal + speeds.tangent * geometry::turned_right(normal);
    state.spin = -speeds.rim / context.ball.radius;
}

// A ball among its supports, while blows change its state.
struct Struck {
    State state;
    std::vector<ContactPoint> touched;  // all that is touched, and
    std::vector<ContactPoint> points;   // of what shares a normal the one that counts
    Contact known;                      // that the caller says is touched
    std::vector<Transition::ContactEvent> blows;
    double still = 0;             // m/s: slower than this along a normal it neither closes nor parts
    double rounding = 0;          // m/s: slower than this, after what happens here, is not moving
    std::optional<Vec2> gripped;  // the normal at which an impact stopped the slip, if nothing came after
};

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

// The supports that the ball closes on, fastest first.
std::vector<std::size_t> closing_supports(MotionContext const& context, Struck const& struck) {
    std::vector<std::size_t> closing;
    auto const speed = [&](std::size_t i) { return dot(struck.state.velocity, struck.points[i].normal); };
    Vec2 const pull = acceleration_in(context.field, struck.state.position, struck.state.velocity);
    for (std::size_t i = 0; i < struck.points.size(); ++i)
        if (speed(i) < -struck.still &&
            dip_of(speed(i), second_derivative(struck.points[i], struck.state.velocity, pull)) > least_dip)
            closing.push_back(i);
    std::stable_sort(closing.begin(), closing.end(), [&](std::size_t i, std::size_t j) { return speed(i) < speed(j); });
    return closing;
}

// Two supports that the ball closes on at once push together, so that neither is the first: a ball that falls into the
// middle of a groove stays there (physics.md 7.1). False when that would take a pull.
bool strike_both(MotionContext const& context, Struck& struck, std::size_t i, std::size_t j) {
    ContactPoint const& a = struck.points[i];
    ContactPoint const& b = struck.points[j];
    Material const& of_a = material_of(context.terrain, a.contact.feature);
    Material const& of_b = material_of(context.terrain, b.contact.feature);
    double const cosine = dot(a.normal, b.normal), sine_square = 1 - cosine * cosine;
    if (sine_square < parallel) return false;
    double const e_a = context.crowded ? 0 : of_a.restitution, e_b = context.crowded ? 0 : of_b.restitution;
    double const p = -(1 + e_a) * dot(struck.state.velocity, a.normal);
    double const q = -(1 + e_b) * dot(struck.state.velocity, b.normal);
    double const push_a = (p - cosine * q) / sine_square, push_b = (q - cosine * p) / sine_square;
    if (push_a < 0 || push_b < 0) return false;
    struck.state.velocity += push_a * a.normal + push_b * b.normal;
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

void choose_supports(MotionContext const& context, Struck& struck) {
    Vec2 const pull = acceleration_in(context.field, struck.state.position, struck.state.velocity);
    struck.points = kept_apart(struck.touched, struck.state.velocity, pull, struck.rounding);
}

// Blows until nothing closes; what would go on for ever ends with the ball standing.
void strike_all(MotionContext const& context, Struck& struck) {
    bool const in_socket = std::any_of(struck.touched.begin(), struck.touched.end(),
                                       [](ContactPoint const& s) { return s.normals_turn != 0; });
    for (int blow = 0;; ++blow) {
        // A socket pushes against the velocity there is.
        if (in_socket && blow > 0) choose_supports(context, struck);
        std::vector<std::size_t> const closing = closing_supports(context, struck);
        if (closing.empty()) return;
        if (blow == most_blows) break;
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

SurfaceState surface_state_on(MotionContext const& context, Struck const& struck, std::size_t i) {
    ContactPoint const& point = struck.points[i];
    ContactSpeeds const speeds = speeds_at(context, struck.state, point.normal);
    SurfaceState on_track;
    on_track.contact = point.contact;
    on_track.track = track_of(context.terrain, point.contact, context.ball.radius);
    on_track.q = nearest_coordinate(on_track.track, struck.state.position);
    on_track.speed = std::abs(speeds.tangent) <= struck.rounding ? 0 : speeds.tangent;
    on_track.rim =
        std::abs(speeds.slip()) <= struck.rounding || struck.gripped == point.normal ? on_track.speed : speeds.rim;
    on_track.angle = struck.state.angle;
    return on_track;
}

// How fast the ball leaves the support, if so slowly that its bounces are summed (physics.md 6.2); nothing if it
// flies.
std::optional<double> hop_on(MotionContext const& context, Struck const& struck, std::size_t i) {
    double const normal_speed = dot(struck.state.velocity, struck.points[i].normal);
    if (normal_speed <= struck.still) return 0;
    if (!fits(context.terrain, struck.points[i].contact, context.ball.radius)) {
        if (normal_speed <= sway_speed(context, struck.state)) return 0;
        return std::nullopt;
    }
    // What drives a ball against the end of its track may be friction, of which the pressing field does not tell.
    bool const known = struck.points[i].contact == struck.known;
    if (known && struck.blows.empty() && normal_speed <= sway_speed(context, struck.state)) return 0;
    SurfaceState const on_track = surface_state_on(context, struck, i);
    double const pressing = normal_force(context, on_track);
    double const lowest = sums_exactly(context, on_track, normal_speed) ? lowest_hop_of_sums : lowest_hop;
    if (!(normal_speed * normal_speed < 2 * pressing * lowest * context.ball.radius)) return std::nullopt;
    return normal_speed;
}

// Whether a moving ball is carried off the support by its way alone, as past a point.
bool parts(MotionContext const& context, Struck const& struck, std::size_t i, Vec2 const& pull) {
    double const square = struck.state.velocity.squaredNorm();
    double const rounding = bend_rounding + place_rounding(struck.state.position, context.ball.radius);
    return square > struck.rounding * struck.rounding &&
           second_derivative(struck.points[i], struck.state.velocity, pull) >
               parting * rounding * (geometry::length(pull) + square / context.ball.radius);
}

Transition ride_from(MotionContext const& context, SurfaceState const& free_state, double time) {
    Transition transition;
    // Full grip slows a ball that slips: what its way pressed on before may press no more.
    SurfaceState const on_track =
        is_pressed(context, free_state) ? held_by_full_grip(context, free_state) : free_state;
    if (!is_pressed(context, on_track)) {
        transition.plan = plan_flight(context, state_of(context, on_track), time);
        transition.contact_events.push_back({EventKind::lift, on_track.contact});
        return transition;
    }
    ContactMode const mode = contact_mode_for(context, on_track, ModeHint::none);
    transition.track_ends =
        ends_of_track(context.terrain, on_track.contact, on_track.track, on_track.q, context.ball.radius);
    transition.plan = mode.phase == Phase::rest ? plan_standing(state_of(context, on_track), on_track.contact, 0, time)
                                                : plan_track(context, on_track, mode, transition.track_ends, time);
    if (mode.phase == Phase::rest) transition.contact_events.push_back({EventKind::rest, on_track.contact});
    return transition;
}

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

// A standing ball between two supports that hold it: at rest, or spinning until friction has stopped it
// (physics.md 7.2).
std::optional<Transition> wedged(MotionContext const& context, Struck const& struck,
                                 std::vector<std::size_t> const& kept, double time) {
    double const rim = -context.ball.radius * struck.state.spin;
    bool const spins = std::abs(rim) > struck.rounding;
    double const slip_sign = !spins ? 0 : rim < 0 ? 1 : -1;
    Vec2 const load = -acceleration_in(context.field, struck.state.position, Vec2::Zero());
    for (std::size_t i = 0; i < kept.size(); ++i) {
        ContactPoint const& socket = struck.points[kept[i]];
        if (socket.normals_turn == 0 || dot(load, socket.normal) < (1 - parallel) * geometry::length(load)) continue;
        State state = struck.state;
        state.velocity = Vec2::Zero();
        double const mu = material_of(context.terrain, socket.contact.feature).friction;
        if (std::isinf(mu) || !spins) state.spin = 0;
        double const rim_rate = state.spin == 0 ? 0 : slip_sign * mu * geometry::length(load) / context.ball.inertia;
        Transition transition;
        transition.plan = plan_standing(state, socket.contact, -rim_rate / context.ball.radius, time);
        if (state.spin == 0) transition.contact_events.push_back({EventKind::rest, socket.contact});
        return transition;
    }
    for (std::size_t i = 0; i < kept.size(); ++i) {
        for (std::size_t j = i + 1; j < kept.size(); ++j) {
            ContactPoint const& a = struck.points[kept[i]];
            ContactPoint const& b = struck.points[kept[j]];
            if (std::abs(geometry::cross(a.normal, b.normal)) < parallel) continue;
            double const mu_a = material_of(context.terrain, a.contact.feature).friction;
            double const mu_b = material_of(context.terrain, b.contact.feature).friction;
            State state = struck.state;
            state.velocity = Vec2::Zero();
            bool const grips_fully = std::isinf(mu_a) || std::isinf(mu_b);
            if (grips_fully || !spins) state.spin = 0;
            TwoForces const hold = hold_of(context, state, a, b, grips_fully ? 0 : slip_sign);
            if (!holds(context, state, hold)) continue;
            // What holds by rounding alone does not rub.
            double const pushed = mu_a * std::max(0.0, hold.first) + mu_b * std::max(0.0, hold.second);
            double const rim_rate = grips_fully || !spins ? 0 : slip_sign * pushed / context.ball.inertia;
            Transition transition;
            transition.plan = plan_standing(state, a.contact, -rim_rate / context.ball.radius, time);
            if (state.spin == 0) transition.contact_events.push_back({EventKind::rest, a.contact});
            return transition;
        }
    }
    return std::nullopt;
}

bool presses(MotionContext const& context, Struck const& struck, std::size_t i) {
    ContactPoint const& point = struck.points[i];
    if (fits(context.terrain, point.contact, context.ball.radius))
        return is_pressed(context, surface_state_on(context, struck, i));
    Vec2 const pull = acceleration_in(context.field, struck.state.position, struck.state.velocity);
    return dot(pull, point.normal) < -hold_rounding * geometry::length(pull);
}

// No way out: the ball jams if anything presses on it, else it flies.
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

// Bounces to and fro between surfaces that are not parallel die out like a geometric series, the speeds along them
// included: where none of them would be seen any more the ball stands, and where they crowd it does so as soon as they
// do not leave the reach of touch.
bool stands_among_several(MotionContext const& context, Struck const& struck) {
    std::vector<std::size_t> all(struck.points.size());
    std::iota(all.begin(), all.end(), 0);
    double const pull = geometry::length(acceleration_in(context.field, struck.state.position, struck.state.velocity));
    double const height = context.crowded ? touch_reach : 4 * lowest_hop * context.ball.radius;
    double const speed = geometry::length(struck.state.velocity);
    return all.size() > 1 && speed * speed <= 2 * pull * height && pins(struck, all);
}

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
            bool const are_parallel =
                radius * std::abs(struck.points[i].curvature + struck.points[j].curvature) <= 1e-6;
            if (auto const on = are_parallel ? way_out(context, struck, kept, time) : std::nullopt) return *on;
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

// Along one of several surfaces that a ball keeps to, or else standing: held by them, let go by one of them, or jammed.
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

// Whether the sum of bounces, which goes straight, stays on the track: it ends before the track does, in either
// direction and with room to spare, and has not strayed from its curve.
bool keeps_to_track(MotionContext const& context, SurfaceState const& on_track, LegPlan const& plan) {
    auto const& motion = std::get<Ballistic>(plan.leg.motion);
    double const way = plan.end.time *
                       (geometry::length(motion.from.velocity) + plan.end.time * geometry::length(motion.acceleration));
    if (way == 0) return true;
    if (!on_track.track.straight && way * way > 2 * on_track.track.rho * least_depth) return false;
    TrackEnds const ends =
        ends_of_track(context.terrain, on_track.contact, on_track.track, on_track.q, context.ball.radius);
    return on_track.q - 2 * way > ends.low.q && on_track.q + 2 * way < ends.high.q;
}

Transition kept_transition(MotionContext const& context, Struck& struck, std::vector<std::size_t> const& kept,
                           double time) {
    if (kept.size() > 1) return among_several(context, struck, kept, time);
    if (!fits(context.terrain, struck.points[kept.front()].contact, context.ball.radius)) {
        auto const held = wedged(context, struck, kept, time);
        return held ? *held : stuck(context, struck, kept, time);
    }
    double const hop = *hop_on(context, struck, kept.front());
    SurfaceState const on_track = surface_state_on(context, struck, kept.front());
    if (hop == 0) return ride_from(context, on_track, time);
    Transition transition;
    transition.plan = plan_settling(context, on_track, hop, time);
    if (keeps_to_track(context, on_track, transition.plan)) return transition;
    // Where it would run off or into something before the last bounce, it bounces on, or, if that is not seen, rides.
    bool const seen = hop * hop >= 2 * normal_force(context, on_track) * lowest_hop * context.ball.radius;
    if (seen && !context.crowded) {
        transition.plan = plan_flight(context, struck.state, time);
        return transition;
    }
    return ride_from(context, on_track, time);
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

}  // namespace

Transition resolved(MotionContext const& context, State const& state, double time, Contact known) {
    Struck struck = struck_at(context, state, known);
    strike_all(context, struck);
    if (geometry::length(struck.state.velocity) <= struck.rounding) struck.state.velocity = Vec2::Zero();
    choose_supports(context, struck);
    Vec2 const pull = acceleration_in(context.field, struck.state.position, struck.state.velocity);
    if (stands_among_several(context, struck)) struck.state.velocity = Vec2::Zero();
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < struck.points.size(); ++i)
        if (!is_left_behind(struck.points[i], struck.state.velocity, pull, struck.rounding) &&
            !parts(context, struck, i, pull) && hop_on(context, struck, i))
            kept.push_back(i);
    Transition transition;
    if (kept.empty())
        transition.plan = plan_flight(context, struck.state, time);
    else
        transition = kept_transition(context, struck, kept, time);
    // The first of the bounces that are summed is told with their end.
    if (transition.plan.end.cause != LegEndCause::settles)
        transition.contact_events.insert(transition.contact_events.begin(), struck.blows.begin(), struck.blows.end());
    return transition;
}

}  // namespace physics
