#include "physics/euler.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "physics/steps/stepping.h"

namespace physics {

namespace {

using geometry::dot;

constexpr int impulse_sweeps = 10;
constexpr int projection_sweeps = 4;
constexpr double slow_bounce = 2;      // steps in free fall: what closes more slowly does not bounce
constexpr double euler_still = 1e-4;   // m/s, a touching ball below it is at rest
constexpr double slipping = 1e-6;      // m/s, it slides above it
constexpr double end_overlap = 1e-9;   // m, less is that of the piece beside
constexpr double most_friction = 1e9;  // infinity times nothing is no number

// One ball against another, or against terrain.
struct Collision {
    int a = 0, b = -1;           // -1: terrain
    Vec2 normal = Vec2::Zero();  // unit, towards a
    double overlap = 0;          // m
    Material material;
    Contact contact;
    double bounce = 0;               // m/s, the speed along the normal with which they part
    double pressed = 0, rubbed = 0;  // N s, so far
};

struct Bodies {
    Scene const& scene;
    std::vector<State> states;
    std::vector<Collision> collisions;
};

void integrate(Bodies& bodies, Forces const& forces, double step) {
    for (int i = 0; i < static_cast<int>(bodies.states.size()); ++i) {
        State& state = bodies.states[i];
        state.velocity += step * acceleration_in(field_on(bodies.scene, forces, i), state.position, state.velocity);
        state.position += step * state.velocity;
        state.angle += step * state.spin;
    }
}

// Left of the sense of travel is +1.
int side_of(geometry::Curve const& curve, Vec2 const& point, Vec2 const& normal) {
    auto const* arc = std::get_if<geometry::Arc>(&curve);
    auto const* line = std::get_if<geometry::Segment>(&curve);
    Vec2 const left =
        arc ? Vec2((arc->sweep < 0 ? -1 : 1) * (arc->centre - point)) : geometry::turned_left(line->end - line->start);
    return dot(normal, left) < 0 ? -1 : 1;
}

// Feet within pieces first; then ends, as far as they still overlap a ball that has been pushed out of those.
void collide_with_terrain(Bodies& bodies, int ball) {
    Terrain const& terrain = bodies.scene.terrain;
    Vec2 const place = bodies.states[ball].position;
    double const radius = bodies.scene.balls[ball].radius;
    Vec2 pushed = place;
    for (bool const at_ends : {false, true})
        terrain.tree.each_overlapping({place - Vec2::Constant(radius), place + Vec2::Constant(radius)}, [&](int piece) {
            geometry::Curve const& curve = terrain.pieces[piece].curve;
            geometry::Nearest const nearest = geometry::nearest_point(curve, place);
            if (nearest.inside == at_ends || nearest.distance >= radius || nearest.distance == 0) return;
            if (at_ends && geometry::length(pushed - nearest.point) >= radius - end_overlap) return;
            Vec2 const normal = (place - nearest.point) / nearest.distance;
            bodies.collisions.push_back({ball,
                                         -1,
                                         normal,
                                         radius - nearest.distance,
                                         terrain.pieces[piece].material,
                                         {piece, side_of(curve, nearest.point, normal)},
                                         0,
                                         0,
                                         0});
            if (!at_ends) pushed += (radius - nearest.distance) * normal;
        });
}

void collide_pair(Bodies& bodies, int a, int b) {
    Ball const& one = bodies.scene.balls[a];
    Ball const& other = bodies.scene.balls[b];
    Vec2 const way = bodies.states[a].position - bodies.states[b].position;
    double const distance = geometry::length(way), overlap = one.radius + other.radius - distance;
    if (overlap <= 0) return;
    Material const material{std::sqrt(one.friction * other.friction), std::max(one.restitution, other.restitution), 0};
    Vec2 const normal = distance > 0 ? Vec2(way / distance) : Vec2(0, 1);
    bodies.collisions.push_back({a, b, normal, overlap, material, no_contact, 0, 0, 0});
}

void find_collisions(Bodies& bodies) {
    int const count = static_cast<int>(bodies.states.size());
    for (int i = 0; i < count; ++i) collide_with_terrain(bodies, i);
    auto const left = [&](int i) { return bodies.states[i].position.x() - bodies.scene.balls[i].radius; };
    auto const right = [&](int i) { return bodies.states[i].position.x() + bodies.scene.balls[i].radius; };
    std::vector<int> order(bodies.states.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](int a, int b) { return left(a) != left(b) ? left(a) < left(b) : a < b; });
    for (std::size_t k = 0; k < order.size(); ++k)
        for (std::size_t l = k + 1; l < order.size() && left(order[l]) < right(order[k]); ++l)
            collide_pair(bodies, order[k], order[l]);
}

double yield_of(Bodies const& bodies, int ball) { return ball < 0 ? 0 : 1 / bodies.scene.balls[ball].mass; }

Vec2 velocity_of(Bodies const& bodies, int ball) { return ball < 0 ? Vec2(0, 0) : bodies.states[ball].velocity; }

// Of the rim at the contact, along t = (n.y, -n.x), as far as it comes from the spin. It is the same on both sides.
double rim_of(Bodies const& bodies, int ball) {
    return ball < 0 ? 0 : bodies.scene.balls[ball].radius * bodies.states[ball].spin;
}

void push(Bodies& bodies, int ball, Vec2 const& impulse, double couple) {
    if (ball < 0) return;
    Ball const& of = bodies.scene.balls[ball];
    bodies.states[ball].velocity += impulse / of.mass;
    bodies.states[ball].spin += couple / (of.inertia * of.mass * of.radius);
}

void solve(Bodies& bodies, Collision& c) {
    Vec2 const tangent = geometry::turned_right(c.normal);
    double const yield = yield_of(bodies, c.a) + yield_of(bodies, c.b);
    double const closing = -dot(velocity_of(bodies, c.a) - velocity_of(bodies, c.b), c.normal);
    double const pressed = std::max(0.0, c.pressed + (closing + c.bounce) / yield);
    push(bodies, c.a, (pressed - c.pressed) * c.normal, 0);
    push(bodies, c.b, (c.pressed - pressed) * c.normal, 0);
    c.pressed = pressed;
    double turn = 1 / (bodies.scene.balls[c.a].mass * bodies.scene.balls[c.a].inertia);
    if (c.b >= 0) turn += 1 / (bodies.scene.balls[c.b].mass * bodies.scene.balls[c.b].inertia);
    double const slip =
        dot(velocity_of(bodies, c.a) - velocity_of(bodies, c.b), tangent) + rim_of(bodies, c.a) + rim_of(bodies, c.b);
    double const most = std::min(c.material.friction, most_friction) * c.pressed;
    double const rubbed = std::clamp(c.rubbed - slip / (yield + turn), -most, most);
    push(bodies, c.a, (rubbed - c.rubbed) * tangent, rubbed - c.rubbed);
    push(bodies, c.b, (c.rubbed - rubbed) * tangent, rubbed - c.rubbed);
    c.rubbed = rubbed;
}

// While the ball rolls: friction has stopped the slip and has not come to its end.
void resist_rolling(Bodies& bodies, Collision const& c) {
    Ball const& ball = bodies.scene.balls[c.a];
    if (std::abs(c.rubbed) >= std::min(c.material.friction, most_friction) * c.pressed) return;
    double& spin = bodies.states[c.a].spin;
    double const most = c.material.rolling_resistance * c.pressed / (ball.inertia * ball.mass * ball.radius);
    spin -= std::clamp(spin, -most, most);
}

void apply_impulses(Bodies& bodies, double step) {
    for (Collision& c : bodies.collisions) {
        double const closing = -dot(velocity_of(bodies, c.a) - velocity_of(bodies, c.b), c.normal);
        if (closing > slow_bounce * bodies.scene.gravity * step) c.bounce = c.material.restitution * closing;
    }
    for (int i = 0; i < impulse_sweeps; ++i)
        for (Collision& c : bodies.collisions) solve(bodies, c);
    for (Collision const& c : bodies.collisions) resist_rolling(bodies, c);
}

void project(Bodies& bodies) {
    std::vector<State> const before = bodies.states;
    auto const moved = [&](int i) { return i < 0 ? Vec2(0, 0) : Vec2(bodies.states[i].position - before[i].position); };
    for (int i = 0; i < projection_sweeps; ++i)
        for (Collision const& c : bodies.collisions) {
            double const overlap = c.overlap - dot(moved(c.a) - moved(c.b), c.normal);
            if (overlap <= 0) continue;
            double const share = overlap / (yield_of(bodies, c.a) + yield_of(bodies, c.b));
            bodies.states[c.a].position += share * yield_of(bodies, c.a) * c.normal;
            if (c.b >= 0) bodies.states[c.b].position -= share * yield_of(bodies, c.b) * c.normal;
        }
}

// How a ball stands after the step: on the surface that presses it most, unless it has bounced off.
Standing standing_of(Bodies const& bodies, int ball) {
    Standing standing{bodies.states[ball], Phase::flight, no_contact};
    double most = 0;
    for (Collision const& c : bodies.collisions) {
        if (c.a != ball || c.b >= 0 || c.pressed <= most || c.bounce > 0) continue;
        most = c.pressed;
        standing.contact = c.contact;
        double const along = geometry::cross(standing.state.velocity, c.normal), rim = rim_of(bodies, ball);
        bool const rests = geometry::length(standing.state.velocity) < euler_still && std::abs(rim) < euler_still;
        standing.phase = rests ? Phase::rest : std::abs(along + rim) > slipping ? Phase::slide : Phase::roll;
    }
    return standing;
}

void write_step(Bodies const& bodies, World& world, double then, History& history) {
    for (Collision const& c : bodies.collisions)
        if (c.bounce > 0)
            history.events.push_back(
                {then, c.b < 0 ? EventKind::bounce : EventKind::hit, c.a, bodies.states[c.a], c.contact, c.b});
    for (int i = 0; i < static_cast<int>(bodies.states.size()); ++i) {
        open_leg(world, history, i, world.time);
        Leg const before = world.legs[i];
        write_leg(world, history, i, then, standing_of(bodies, i));
        tell_contact_change(bodies.scene.terrain, before, world.legs[i], i, history);
        tell_phase_change(before, world.legs[i], i, history);
    }
}

}  // namespace

void advance_with(Euler const& method, Scene const& scene, World& world, double until, History& history) {
    std::size_t const first_event = history.events.size();
    double const step = 1 / method.rate;
    while (world.time < until) {
        double const then = time_of_step(world, method.rate, world.steps_taken + 1);
        Bodies bodies{scene, {}, {}};
        for (Leg const& leg : world.legs) bodies.states.push_back(std::get<Straight>(leg.motion).from);
        integrate(bodies, world.forces, step);
        find_collisions(bodies);
        apply_impulses(bodies, step);
        project(bodies);
        write_step(bodies, world, then, history);
        ++world.steps_taken;
        world.time = then;
    }
    sort_events(history, first_event);
}

}  // namespace physics
