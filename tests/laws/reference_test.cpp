// The methods of one ball against a reference that knows none of their formulas.
#include <cmath>
#include <optional>
#include <string>

#include <doctest/doctest.h>

#include "bounds.h"
#include "reference.h"

using namespace laws;

namespace {

struct Scene {
    std::string name;
    physics::Scene scene;
    double time = 0;   // s
    double error = 0;  // m/s: so many metres for each second of the reference's step is it off
    std::optional<physics::Pull> pull = {};
};

std::vector<Scene> all_scenes() {
    double const loop_speed = 1.05 * std::sqrt(11.0 / 3 * g * 1.5);
    auto const grip = material(0.9);
    physics::Scene rough = floor_with(disc_at({0, 0.5}, {5, 0}), material(0.2, 0, 0.02));
    physics::Scene damped = floor_with(disc_at({1, 2}), material(0.3, 0.4));
    damped.drag = {2, 0.3};
    std::vector<Scene> all;
    all.push_back({"rolls down a ramp", slope_with(0.3, disc_at({0, 0}), grip).scene, 2, 10});
    all.push_back({"slides down a ramp", slope_with(0.5, disc_at({0, 0}), material(0.1)).scene, 2, 15});
    all.push_back({"slides, then rolls against resistance", rough, 3, 15});
    all.push_back({"bounces with spin", floor_with(disc_at({0, 2}, {1, 0}, 9), material(0.4, 0.8)), 2.6, 40});
    all.push_back({"swings in a valley",
                   scene_of({arc({0, 3}, 3, -pi, pi, grip)}, {disc_at({2.5 * std::sin(0.8), 3 - 2.5 * std::cos(0.8)})}),
                   3, 20});
    all.push_back({"loops",
                   scene_of({arc({0, 2}, 2, -pi / 2, 2 * pi, material(full_grip))}, {rolling({0, 0.5}, loop_speed)}),
                   1.5, 90});
    all.push_back({"is dragged, hits the floor and comes to the hook", damped, 3, 40, physics::Pull{0, {3, 0.4}}});
    return all;
}

}  // namespace

TEST_CASE("exact and steps are where a brute-force reference has the ball, the nearer the smaller its steps") {
    for (Scene const& scene : all_scenes())
        for (double const step : {4e-5, 4e-6}) {
            if (sanitized && step < 1e-5) continue;
            CAPTURE(scene.name);
            CAPTURE(step);
            physics::Forces forces;
            forces.pull = scene.pull;
            physics::State const reference = reference_after(scene.scene, forces, scene.time, step);
            for (physics::Method const& method :
                 {physics::Method(physics::Exact{}), physics::Method(physics::Steps{})}) {
                Run run(method, scene.scene);
                if (scene.pull) run.pull(scene.pull->ball, scene.pull->target);
                run.to(scene.time);
                physics::State const state = run.state();
                CHECK(geometry::length(state.position - reference.position) <= scene.error * step);
                CHECK(std::abs(state.angle - reference.angle) <= 2 * scene.error * step);
                CHECK(geometry::length(state.velocity - reference.velocity) <= 10 * scene.error * step);
            }
        }
}
