#include "scenes.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace laws {

physics::Ball disc_at(Vec2 const& position, Vec2 const& velocity, double spin) {
    physics::Ball ball;
    ball.start.position = position;
    ball.start.velocity = velocity;
    ball.start.spin = spin;
    return ball;
}

physics::Scene scene_of(std::vector<physics::Piece> pieces, std::vector<physics::Ball> balls) {
    physics::Scene scene;
    scene.terrain = physics::terrain_of(std::move(pieces));
    scene.balls = std::move(balls);
    scene.gravity = g;
    return scene;
}

physics::Scene floor_with(physics::Ball const& ball, physics::Material const& of) {
    return scene_of({line({-1000, 0}, {1000, 0}, of)}, {ball});
}

Slope slope_with(double angle, physics::Ball ball, physics::Material const& of) {
    Slope slope;
    slope.down = Vec2(std::cos(angle), -std::sin(angle));
    slope.normal = geometry::turned_left(slope.down);
    ball.start.position = ball.radius * slope.normal;
    slope.scene = scene_of({line(-200 * slope.down, 200 * slope.down, of)}, {ball});
    return slope;
}

physics::Scene course_at(Vec2 const& origin, double restitution) {
    auto const of = material(0.3, restitution, 0.01);
    auto const segment = [&](double x1, double y1, double x2, double y2) {
        return line(origin + Vec2(x1, y1), origin + Vec2(x2, y2), of);
    };
    return scene_of({segment(-4, 4, 0, 1), segment(0, 1, 3, 1), arc(origin + Vec2(3, 3), 2, -pi / 2, pi / 3, of),
                     segment(6, 0, 12, 0), segment(12, 0, 12, 6), segment(-4, 4, -4, 8)},
                    {disc_at(origin + Vec2(-2, 4.25))});
}

Run::Run(physics::Method const& m, physics::Scene const& s)
    : method(m), scene(s), world(physics::world_at_start(method, scene, history)) {}

void Run::to(double time) { physics::advance(method, scene, world, time, history); }

void Run::pull(int ball, Vec2 const& target) {
    physics::Forces forces = world.forces;
    forces.pull = physics::Pull{ball, target};
    physics::apply(method, scene, world, forces, history);
}

void Run::release() {
    physics::Forces forces = world.forces;
    forces.pull.reset();
    physics::apply(method, scene, world, forces, history);
}

physics::State state_after(physics::Method const& method, physics::Scene const& scene, double time) {
    Run run(method, scene);
    run.to(time);
    return run.state();
}

double deepest_overlap(Run const& run) {
    double deepest = 0;
    for (std::size_t i = 0; i < run.scene.balls.size(); ++i) {
        double const r = run.scene.balls[i].radius;
        Vec2 const p = run.state(static_cast<int>(i)).position;
        deepest = std::max(deepest, r - p.y());
        for (std::size_t j = 0; j < i; ++j) {
            double const between = geometry::length(p - run.state(static_cast<int>(j)).position);
            deepest = std::max(deepest, r + run.scene.balls[j].radius - between);
        }
    }
    return deepest;
}

double fastest(Run const& run) {
    double most = 0;
    for (std::size_t i = 0; i < run.scene.balls.size(); ++i)
        most = std::max(most, geometry::length(run.state(static_cast<int>(i)).velocity));
    return most;
}

double highest_when_unloaded(Run& run) {
    run.to(2);
    run.pull(1, {0, 6});
    double highest = 0;
    for (int i = 0; i < 60; ++i) {
        run.to(2 + i / 60.0);
        highest = std::max(highest, run.state(0).position.y());
    }
    return highest;
}

Vec2 momentum_of(Run const& run) {
    Vec2 sum = Vec2::Zero();
    for (std::size_t i = 0; i < run.scene.balls.size(); ++i)
        sum += run.scene.balls[i].mass * run.state(static_cast<int>(i)).velocity;
    return sum;
}

bool same_bits(physics::State const& a, physics::State const& b) {
    double const p[] = {a.position.x(), a.position.y(), a.velocity.x(), a.velocity.y(), a.angle, a.spin};
    double const q[] = {b.position.x(), b.position.y(), b.velocity.x(), b.velocity.y(), b.angle, b.spin};
    return std::memcmp(p, q, sizeof p) == 0;
}

double energy_of(Run const& run) {
    double energy = 0;
    for (std::size_t i = 0; i < run.scene.balls.size(); ++i) {
        physics::Ball const& ball = run.scene.balls[i];
        physics::State const state = run.state(static_cast<int>(i));
        double const rim = ball.radius * state.spin;
        energy += ball.mass * (0.5 * (geometry::dot(state.velocity, state.velocity) + ball.inertia * rim * rim) +
                               run.scene.gravity * state.position.y());
    }
    return energy;
}

int count_of(physics::History const& history, physics::EventKind kind) {
    return static_cast<int>(std::count_if(history.events.begin(), history.events.end(),
                                          [&](physics::Event const& event) { return event.kind == kind; }));
}

}  // namespace laws
