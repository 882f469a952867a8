#include "scenes.h"

#include <algorithm>
#include <cmath>

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
