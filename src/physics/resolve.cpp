// What becomes of a ball where it touches terrain: blows, then which contacts it keeps.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "physics/contacts_at.h"
#include "physics/course_track.h"
#include "physics/impact.h"
#include "physics/ride.h"

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
// Forces below this share of the field are rounding.
constexpr double hold_rounding = 1e-12;
// Of a pull, the share against which a further contact bars the way: those of the ends of one wall differ by less.
constexpr double barring = 1e-3;
// What the caller knows to be touched lies within this of the ball's way, in m, or its place is another.
constexpr double known_reach = 1e-6;
// Normals nearer than this to opposite do not hold what lies between them.
constexpr double opposite_normals = 4e-9;

ContactSpeeds speeds_at(Setting const& setting, State const& state, Vec2 const& normal) {
    return {dot(state.velocity, normal), dot(state.velocity, geometry::turned_right(normal)),
            -setting.ball.radius * state.spin};
}

void set_speeds(Setting const& setting, State& state, Vec2 const& normal, ContactSpeeds const& speeds) {
    state.velocity = speeds.normal * normal + speeds.tangent * geometry::turned_right(normal);
    state.spin = -speeds.rim / setting.ball.radius;
}

// A ball among its supports, while blows change its state.
struct Struck {
    State state;
    std::vector<Support> touched;   // all that is touched, and
    std::vector<Support> supports;  // of what shares a normal the one that counts
    Contact known;  // that the caller says is touched
    std::vector<Turnout::Happening> blows;
    double still = 0;                    // m/s: slower than this along a normal it neither closes nor parts
    double rounding = 0;                 // m/s: slower than this, after what happens here, is not moving
    std::optional<Vec2> gripped;         // the normal at which an impact stopped the slip, if nothing came after
};

void note_blow(Struck& struck, EventKind kind, Contact contact) {
    for (Turnout::Happening const& blow : struck.blows)
        if (blow.contact == contact && blow.kind == kind) return;
    struck.blows.push_back({kind, contact});
}

void strike(Setting const& setting, Struck& struck, std::size_t i) {
    Support const& support = struck.supports[i];
    Material const& material = material_of(setting.terrain, support.contact.feature);
    ContactSpeeds const before = speeds_at(setting, struck.state, support.normal);
    double const restitution = setting.crowded ? 0 : material.restitution;
    ContactSpeeds const after = after_impact(before, restitution, material.friction, setting.ball.inertia);
    set_speeds(setting, struck.state, support.normal, after);
    struck.gripped = after.slip() == 0 ? std::optional(support.normal) : std::nullopt;
    note_blow(struck, after.normal > 0 ? EventKind::bounce : EventKind::land, support.contact);
}

// Friction of at most `limit` (m/s) against the slip at a contact.
void rub(Setting const& setting, State& state, Vec2 const& normal, double limit) {
    double const k = setting.ball.inertia;
    ContactSpeeds speeds = speeds_at(setting, state, normal);
    double const impulse = std::clamp(-speeds.slip() * k / (1 + k), -limit, limit);
    speeds.tangent += impulse;
    speeds.rim -= impulse / k;
    set_speeds(setting, state, normal, speeds);
}

// The supports that the ball closes on, fastest first.
std::vector<std::size_t> closing_supports(Struck const& struck) {
    std::vector<std::size_t> closing;
    auto const speed = [&](std::size_t i) { return dot(struck.state.velocity, struck.supports[i].normal); };
    for (std::size_t i = 0; i < struck.supports.size(); ++i)
        if (speed(i) < -struck.still) closing.push_back(i);
    std::stable_sort(closing.begin(), closing.end(), [&](std::size_t i, std::size_t j) { return speed(i) < speed(j); });
    return closing;
}

// Two supports that the ball closes on at once push together, so that neither is the first: a ball that falls into the
// middle of a groove stays there (physics.md 2.12). False when that would take a pull.
bool strike_both(Setting const& setting, Struck& struck, std::size_t i, std::size_t j) {
    Support const& a = struck.supports[i];
    Support const& b = struck.supports[j];
    Material const& of_a = material_of(setting.terrain, a.contact.feature);
    Material const& of_b = material_of(setting.terrain, b.contact.feature);
    double const cosine = dot(a.normal, b.normal), sine_square = 1 - cosine * cosine;
    if (sine_square < parallel) return false;
    double const e_a = setting.crowded ? 0 : of_a.restitution, e_b = setting.crowded ? 0 : of_b.restitution;
    double const p = -(1 + e_a) * dot(struck.state.velocity, a.normal);
    double const q = -(1 + e_b) * dot(struck.state.velocity, b.normal);
    double const push_a = (p - cosine * q) / sine_square, push_b = (q - cosine * p) / sine_square;
    if (push_a < 0 || push_b < 0) return false;
    struck.state.velocity += push_a * a.normal + push_b * b.normal;
    // Neither rubs first: the mean of both orders, which has no more energy than they.
    State a_first = struck.state, b_first = struck.state;
    rub(setting, a_first, a.normal, of_a.friction * push_a);
    rub(setting, a_first, b.normal, of_b.friction * push_b);
    rub(setting, b_first, b.normal, of_b.friction * push_b);
    rub(setting, b_first, a.normal, of_a.friction * push_a);
    struck.state.velocity = (a_first.velocity + b_first.velocity) / 2;
    struck.state.spin = (a_first.spin + b_first.spin) / 2;
    note_blow(struck, e_a > 0 ? EventKind::bounce : EventKind::land, a.contact);
    note_blow(struck, e_b > 0 ? EventKind::bounce : EventKind::land, b.contact);
    struck.gripped.reset();
    return true;
}

// Blows until nothing closes; what would go on for ever ends with the ball standing.
void strike_all(Setting const& setting, Struck& struck) {
    for (int blow = 0;; ++blow) {
        std::vector<std::size_t> const closing = closing_supports(struck);
        if (closing.empty()) return;
        if (blow == most_blows) break;
        if (closing.size() == 2 && strike_both(setting, struck, closing[0], closing[1])) continue;
        strike(setting, struck, closing.front());
    }
    // To and fro between two walls that face each other it is only across them that it stands.
    Vec2 const normal = struck.supports[closing_supports(struck).front()].normal;
    struck.state.velocity -= dot(struck.state.velocity, normal) * normal;
    if (!closing_supports(struck).empty()) struck.state.velocity = Vec2::Zero();
}

Rider rider_on(Setting const& setting, Struck const& struck, std::size_t i) {
    Support const& support = struck.supports[i];
    ContactSpeeds const speeds = speeds_at(setting, struck.state, support.normal);
    Rider rider;
    rider.contact = support.contact;
    rider.track = track_of(setting.terrain, support.contact, setting.ball.radius);
    rider.q = nearest_coordinate(rider.track, struck.state.position);
    rider.speed = std::abs(speeds.tangent) <= struck.rounding ? 0 : speeds.tangent;
    rider.rim =
        std::abs(speeds.slip()) <= struck.rounding || struck.gripped == support.normal ? rider.speed : speeds.rim;
    rider.angle = struck.state.angle;
    return rider;
}

// How fast the ball leaves the support, if so slowly that its bounces are summed (physics.md 2.13); nothing if it flies.
std::optional<double> hop_on(Setting const& setting, Struck const& struck, std::size_t i) {
    double const normal_speed = dot(struck.state.velocity, struck.supports[i].normal);
    if (normal_speed <= struck.still) return 0;
    if (!fits(setting.terrain, struck.supports[i].contact, setting.ball.radius)) {
        if (normal_speed <= sway_speed(setting, struck.state)) return 0;
        return std::nullopt;
    }
    // What drives a ball against the end of its track may be friction, of which the pressing field does not tell.
    bool const known = struck.supports[i].contact == struck.known;
    if (known && struck.blows.empty() && normal_speed <= sway_speed(setting, struck.state)) return 0;
    Rider const rider = rider_on(setting, struck, i);
    double const pressing = normal_force(setting, rider);
    double const lowest = sums_exactly(setting, rider, normal_speed) ? lowest_hop_of_sums : lowest_hop;
    if (!(normal_speed * normal_speed < 2 * pressing * lowest * setting.ball.radius)) return std::nullopt;
    return normal_speed;
}

Turnout ride_from(Setting const& setting, Rider const& free_rider, double time) {
    Turnout turnout;
    if (!is_pressed(setting, free_rider)) {
        turnout.course = flight_course(setting, state_of(setting, free_rider), time);
        turnout.happenings.push_back({EventKind::lift, free_rider.contact});
        return turnout;
    }
    Rider const rider = held_by_full_grip(setting, free_rider);
    Law const law = law_for(setting, rider, Onset::none);
    turnout.ends = ends_of_track(setting.terrain, rider.contact, rider.track, rider.q, setting.ball.radius);
    turnout.course = law.phase == Phase::rest ? standing_course(state_of(setting, rider), rider.contact, 0, time)
                                              : track_course(setting, rider, law, turnout.ends, time);
    if (law.phase == Phase::rest) turnout.happenings.push_back({EventKind::rest, rider.contact});
    return turnout;
}

// The normal forces with which two supports hold a standing ball whose rim slides with `slip_sign` (0: it does not).
struct TwoSupports {
    double first = 0, second = 0;
};
TwoSupports hold_of(Setting const& setting, State const& state, Support const& a, Support const& b, double slip_sign) {
    auto const push = [&](Support const& s) {
        double const friction =
            slip_sign == 0 ? 0 : material_of(setting.terrain, s.contact.feature).friction * slip_sign;
        return Vec2(s.normal - friction * geometry::turned_right(s.normal));
    };
    Vec2 const p = push(a), q = push(b), load = -acceleration_in(setting.field, state.position, Vec2::Zero());
    double const span = geometry::wedge(p, q);
    return {geometry::wedge(load, q) / span, geometry::wedge(p, load) / span};
}

// Neither support would have to pull: a force that is rounding is none.
bool holds(Setting const& setting, State const& state, TwoSupports const& hold) {
    double const least = -hold_rounding * geometry::length(acceleration_in(setting.field, state.position, Vec2::Zero()));
    return hold.first >= least && hold.second >= least;
}

// A standing ball between two supports that hold it: at rest, or spinning until friction has stopped it
// (physics.md 2.12).
std::optional<Turnout> wedged(Setting const& setting, Struck const& struck, std::vector<std::size_t> const& kept,
                              double time) {
    double const rim = -setting.ball.radius * struck.state.spin;
    bool const spins = std::abs(rim) > struck.rounding;
    double const slip_sign = !spins ? 0 : rim < 0 ? 1 : -1;
    for (std::size_t i = 0; i < kept.size(); ++i) {
        for (std::size_t j = i + 1; j < kept.size(); ++j) {
            Support const& a = struck.supports[kept[i]];
            Support const& b = struck.supports[kept[j]];
            if (std::abs(geometry::wedge(a.normal, b.normal)) < parallel) continue;
            double const mu_a = material_of(setting.terrain, a.contact.feature).friction;
            double const mu_b = material_of(setting.terrain, b.contact.feature).friction;
            State state = struck.state;
            state.velocity = Vec2::Zero();
            bool const grips_fully = std::isinf(mu_a) || std::isinf(mu_b);
            if (grips_fully || !spins) state.spin = 0;
            TwoSupports const hold = hold_of(setting, state, a, b, grips_fully ? 0 : slip_sign);
            if (!holds(setting, state, hold)) continue;
            double const rim_rate =
                grips_fully ? 0 : slip_sign * (mu_a * hold.first + mu_b * hold.second) / setting.ball.inertia;
            Turnout turnout;
            turnout.course = standing_course(state, a.contact, -rim_rate / setting.ball.radius, time);
            if (state.spin == 0) turnout.happenings.push_back({EventKind::rest, a.contact});
            return turnout;
        }
    }
    return std::nullopt;
}

bool presses(Setting const& setting, Struck const& struck, std::size_t i) {
    Support const& support = struck.supports[i];
    if (fits(setting.terrain, support.contact, setting.ball.radius))
        return is_pressed(setting, rider_on(setting, struck, i));
    return dot(acceleration_in(setting.field, struck.state.position, struck.state.velocity), support.normal) < 0;
}

// No way out: the ball jams if anything presses on it, else it flies.
Turnout stuck(Setting const& setting, Struck const& struck, std::vector<std::size_t> const& kept, double time) {
    Turnout turnout;
    State state = struck.state;
    for (std::size_t const i : kept) {
        if (!presses(setting, struck, i)) continue;
        state.velocity = Vec2::Zero();
        state.spin = 0;
        turnout.course = standing_course(state, struck.supports[i].contact, 0, time);
        turnout.happenings.push_back({EventKind::rest, struck.supports[i].contact});
        return turnout;
    }
    turnout.course = flight_course(setting, state, time);
    return turnout;
}

// Along the support that leads a ball away from the others that it keeps to, if there is one.
std::optional<Turnout> way_out(Setting const& setting, Struck const& struck, std::vector<std::size_t> const& kept,
                               double time) {
    for (std::size_t const i : kept) {
        if (!fits(setting.terrain, struck.supports[i].contact, setting.ball.radius)) continue;
        Rider const rider = rider_on(setting, struck, i);
        if (!is_pressed(setting, rider)) continue;
        double const force = normal_force(setting, rider);
        Law const law = law_for(setting, rider, Onset::none);
        double const a =
            law.phase == Phase::rest ? 0 : law.alpha * tangent_acceleration(setting, rider) + law.beta * force;
        Vec2 const way = (rider.speed != 0 ? rider.speed : a) * geometry::turned_right(struck.supports[i].normal);
        bool free = true;
        for (std::size_t const j : kept)
            free = free && (j == i || dot(way, struck.supports[j].normal) >= -parallel * geometry::length(way));
        if (free) return ride_from(setting, rider, time);
    }
    return std::nullopt;
}

// Two surfaces that are not parallel leave a ball that keeps to both no way to move.
bool pins(Struck const& struck, std::vector<std::size_t> const& kept) {
    for (std::size_t const i : kept)
        for (std::size_t const j : kept)
            if (std::abs(geometry::wedge(struck.supports[i].normal, struck.supports[j].normal)) >= parallel)
                return true;
    return false;
}

// Bounces to and fro between surfaces that are not parallel die out like a geometric series, the speeds along them
// included: where none of them would be seen any more the ball stands, and where they crowd it does so as soon as they
// do not leave the reach of touch.
bool stands_among_several(Setting const& setting, Struck const& struck) {
    std::vector<std::size_t> all(struck.supports.size());
    std::iota(all.begin(), all.end(), 0);
    double const pull = geometry::length(acceleration_in(setting.field, struck.state.position, struck.state.velocity));
    double const height = setting.crowded ? touch_reach : 4 * lowest_hop * setting.ball.radius;
    double const speed = geometry::length(struck.state.velocity);
    return all.size() > 1 && speed * speed <= 2 * pull * height && pins(struck, all);
}

// Along two straight walls as far apart as the ball is wide, neither of which presses on it.
std::optional<Turnout> between_walls(Setting const& setting, Struck const& struck, std::size_t i, std::size_t j,
                                     double time) {
    Rider const rider = rider_on(setting, struck, i);
    if (!rider.track.straight || struck.supports[j].curvature != 0 || is_pressed(setting, rider) ||
        is_pressed(setting, rider_on(setting, struck, j)))
        return std::nullopt;
    Law law;
    law.phase = Phase::slide;
    Turnout turnout;
    turnout.ends = ends_of_track(setting.terrain, rider.contact, rider.track, rider.q, setting.ball.radius);
    turnout.course = track_course(setting, rider, law, turnout.ends, time);
    return turnout;
}

// Between two points as far apart as the ball is wide, within touch, it is held by rounding alone: it passes them. By two
// surfaces that face each other it may be held no better.
std::optional<Turnout> passing(Setting const& setting, Struck const& struck, std::vector<std::size_t> const& kept,
                               double time) {
    double const radius = setting.ball.radius;
    Vec2 const load = acceleration_in(setting.field, struck.state.position, Vec2::Zero());
    auto const faces = [&](std::size_t i, std::size_t j) {
        Vec2 const sum = struck.supports[i].normal + struck.supports[j].normal;
        bool const points = setting.terrain.is_vertex(struck.supports[i].contact.feature) &&
                            setting.terrain.is_vertex(struck.supports[j].contact.feature);
        double const nearest = points ? std::sqrt(8 * touch_reach / radius) : opposite_normals;
        return geometry::length(sum) <= nearest;
    };
    for (std::size_t const i : kept) {
        if (!fits(setting.terrain, struck.supports[i].contact, radius)) return std::nullopt;
        for (std::size_t const j : kept) {
            if (i >= j || !faces(i, j)) continue;
            Vec2 const normal = struck.supports[i].normal - struck.supports[j].normal;
            Vec2 const along = load - (dot(load, normal) / dot(normal, normal)) * normal;
            double const pull = geometry::length(along);
            if (!(pull > hold_rounding * geometry::length(load))) continue;
            bool const barred =
                std::any_of(struck.supports.begin(), struck.supports.end(), [&](Support const& s) {
                    return &s != &struck.supports[i] && &s != &struck.supports[j] &&
                           dot(along, s.normal) < -barring * pull;
                });
            if (barred) continue;
            if (auto const on = between_walls(setting, struck, i, j, time)) return *on;
            Vec2 const sum = struck.supports[i].normal + struck.supports[j].normal;
            double const way = radius * geometry::length(sum) / 2 + touch_reach / 8;
            Turnout turnout;
            turnout.course.leg.since = time;
            State state = struck.state;
            double const speed = std::max(0.0, dot(state.velocity, along) / pull);
            state.velocity = speed / pull * along;
            turnout.course.leg.motion = Ballistic{state, along, 0};
            turnout.course.duration = 2 * way / (speed + std::sqrt(speed * speed + 2 * pull * way));
            turnout.course.leg.until = time + turnout.course.duration;
            turnout.course.ending = Ending::meets;
            return turnout;
        }
    }
    return std::nullopt;
}

// Along one of several surfaces that a ball keeps to, or else standing: held by them, let go by one of them, or jammed.
Turnout among_several(Setting const& setting, Struck& struck, std::vector<std::size_t> const& kept, double time) {
    if (struck.state.velocity != Vec2::Zero())
        if (auto const on = way_out(setting, struck, kept, time)) return *on;
    if (pins(struck, kept)) struck.state.velocity = Vec2::Zero();
    if (auto const on = passing(setting, struck, kept, time)) return *on;
    if (auto const held = wedged(setting, struck, kept, time)) return *held;
    if (auto const on = way_out(setting, struck, kept, time)) return *on;
    return stuck(setting, struck, kept, time);
}

// Whether the sum of bounces, which goes straight, stays on the track: it ends before the track does, in either direction
// and with room to spare, and has not strayed from its curve.
bool keeps_to_track(Setting const& setting, Rider const& rider, Course const& course) {
    auto const& motion = std::get<Ballistic>(course.leg.motion);
    double const way = course.duration * (geometry::length(motion.from.velocity) +
                                          course.duration * geometry::length(motion.acceleration));
    if (way == 0) return true;
    if (!rider.track.straight && way * way > 2 * rider.track.rho * least_depth) return false;
    TrackEnds const ends = ends_of_track(setting.terrain, rider.contact, rider.track, rider.q, setting.ball.radius);
    return rider.q - 2 * way > ends.low.q && rider.q + 2 * way < ends.high.q;
}

Turnout kept_turnout(Setting const& setting, Struck& struck, std::vector<std::size_t> const& kept, double time) {
    if (kept.size() > 1) return among_several(setting, struck, kept, time);
    if (!fits(setting.terrain, struck.supports[kept.front()].contact, setting.ball.radius))
        return stuck(setting, struck, kept, time);
    double const hop = *hop_on(setting, struck, kept.front());
    Rider const rider = rider_on(setting, struck, kept.front());
    if (hop == 0) return ride_from(setting, rider, time);
    Turnout turnout;
    turnout.course = settling_course(setting, rider, hop, time);
    if (keeps_to_track(setting, rider, turnout.course)) return turnout;
    // Where it would run off or into something before the last bounce, it bounces on, or, if that is not seen, rides.
    bool const seen = hop * hop >= 2 * normal_force(setting, rider) * lowest_hop * setting.ball.radius;
    if (seen && !setting.crowded) {
        turnout.course = flight_course(setting, struck.state, time);
        return turnout;
    }
    return ride_from(setting, rider, time);
}

void choose_supports(Setting const& setting, Struck& struck) {
    Vec2 const pull = acceleration_in(setting.field, struck.state.position, struck.state.velocity);
    struck.supports = kept_apart(struck.touched, struck.state.velocity, pull, struck.rounding);
}

Struck struck_at(Setting const& setting, State const& state, Contact known) {
    double const pull = geometry::length(acceleration_in(setting.field, state.position, state.velocity));
    double const rounding = resolve_rounding * (geometry::length(state.velocity) + setting.ball.radius * std::abs(state.spin) +
                                              std::sqrt(pull * setting.ball.radius));
    double const still = still_speed(state.position, setting.ball.radius, geometry::length(state.velocity), pull);
    Struck struck{state, contacts_at(setting.terrain, state.position, setting.ball.radius),
                  {},    known,
                  {},    still,
                  rounding, std::nullopt};
    bool const found = std::any_of(struck.touched.begin(), struck.touched.end(),
                                   [&](Support const& s) { return s.contact == known; });
    if (known.feature >= 0 && !found && fits(setting.terrain, known, setting.ball.radius)) {
        Track const track = track_of(setting.terrain, known, setting.ball.radius);
        double const q = nearest_coordinate(track, state.position);
        if (geometry::length(position_at(track, q) - state.position) < known_reach)
            struck.touched.push_back({known, normal_at(track, q), 0, track.straight ? 0 : track.sense / track.rho});
    }
    choose_supports(setting, struck);
    // What rounding has left of a depth must not add up over many bounces.
    for (Support const& s : struck.supports)
        if (s.gap < -least_depth && s.gap >= -8 * touch_reach) struck.state.position -= s.gap * s.normal;
    return struck;
}

}  // namespace

Turnout resolved(Setting const& setting, State const& state, double time, Contact known) {
    Struck struck = struck_at(setting, state, known);
    strike_all(setting, struck);
    choose_supports(setting, struck);
    Vec2 const pull = acceleration_in(setting.field, struck.state.position, struck.state.velocity);
    if (stands_among_several(setting, struck)) struck.state.velocity = Vec2::Zero();
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < struck.supports.size(); ++i)
        if (!is_left_behind(struck.supports[i], struck.state.velocity, pull, struck.rounding) &&
            hop_on(setting, struck, i))
            kept.push_back(i);
    Turnout turnout;
    if (kept.empty())
        turnout.course = flight_course(setting, struck.state, time);
    else
        turnout = kept_turnout(setting, struck, kept, time);
    // The first of the bounces that are summed is told with their end.
    if (turnout.course.ending != Ending::settles)
        turnout.happenings.insert(turnout.happenings.begin(), struck.blows.begin(), struck.blows.end());
    return turnout;
}

}  // namespace physics
