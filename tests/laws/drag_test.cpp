#include <cmath>

#include <doctest/doctest.h>

#include "bounds.h"
#include "scenes.h"

using namespace laws;
using geometry::length;

namespace {

struct Swing {
    double x = 0, v = 0;
};

// The damped oscillator from (x, v), underdamped, by the textbook formula.
Swing swing(double omega, double zeta, Swing const& start, double t) {
    double const decay = zeta * omega, ring = omega * std::sqrt(1 - zeta * zeta);
    double const b = (start.v + decay * start.x) / ring, fall = std::exp(-decay * t);
    double const c = std::cos(ring * t), s = std::sin(ring * t);
    return {fall * (start.x * c + b * s), fall * ((b * ring - decay * start.x) * c - (start.x * ring + decay * b) * s)};
}

}  // namespace

TEST_CASE("dragged in the air a ball swings as the formula says, however little the damping") {
    for (Bound const& bound : bounds_of(Law::drag_in_air))
        for (double const zeta : {0.0, 0.05, 0.7}) {
            physics::Scene scene = scene_of({}, {disc_at({0, 0})});
            scene.drag = {5, zeta};
            Run run(bound.method, scene);
            run.pull(0, {1, 2});
            run.to(3);
            double const omega = 2 * pi * 5;
            double const rest_y = 2 - g / (omega * omega);
            Swing const x = swing(omega, zeta, {-1, 0}, run.world.time),
                        y = swing(omega, zeta, {-rest_y, 0}, run.world.time);
            CHECK(std::abs(run.state().position.x() - 1 - x.x) <= bound.tolerance);
            CHECK(std::abs(run.state().position.y() - rest_y - y.x) <= bound.tolerance);
            CHECK(std::abs(run.state().velocity.x() - x.v) <= bound.tolerance * omega);
        }
}

TEST_CASE("dragged along the floor a disc swings slower by the root of 1 + k") {
    for (Bound const& bound : bounds_of(Law::drag_on_ground)) {
        physics::Scene scene = floor_with(disc_at({0, 0.5}), material(full_grip));
        scene.drag = {1, 0.7};
        Run run(bound.method, scene);
        run.pull(0, {1, 0.5});
        run.to(1);
        double const root = std::sqrt(1.5);
        Swing const x = swing(2 * pi / root, 0.7 / root, {-1, 0}, run.world.time);
        CHECK(run.state().position.x() == doctest::Approx(1 + x.x).epsilon(bound.tolerance));
        CHECK(run.state().angle == doctest::Approx(-(1 + x.x) / 0.5).epsilon(bound.tolerance));
        CHECK(run.state().position.y() == doctest::Approx(0.5).epsilon(bound.tolerance));
    }
}

TEST_CASE("no stiffness and no damping of the drag makes a ball run away") {
    for (physics::Method const& method : {physics::Method(physics::Steps{}), physics::Method(physics::Article{})})
        for (double const frequency : {0.01, 1.0, 10.0, 38.0, 150.0, 600.0, 1e4})
            for (double const zeta : {0.0, 0.5, 1.0, 2.0})
                for (bool const on_floor : {false, true}) {
                    physics::Scene scene =
                        on_floor ? floor_with(disc_at({0, 0.5}), material(0.9)) : scene_of({}, {disc_at({0, 0.5})});
                    scene.gravity = on_floor ? g : 0;
                    scene.drag = {frequency, zeta};
                    CAPTURE(physics::name_of(method));
                    CAPTURE(frequency);
                    CAPTURE(zeta);
                    CAPTURE(on_floor);
                    Run run(method, scene);
                    run.pull(0, {1, 0.4});
                    for (int i = 1; i <= 100; ++i) {
                        run.to(i / 60.0);
                        REQUIRE(length(run.state().position - Vec2(1, 0.4)) <= 2.5);
                    }
                }
}

TEST_CASE("a pull through a wall presses the ball on it and no further") {
    physics::Scene scene = scene_of({line({2, -5}, {2, 5}, material(0.5))}, {disc_at({0, 0})});
    scene.gravity = 0;
    scene.drag = {30, 0.2};
    Run run(physics::Steps{}, scene);
    run.pull(0, {6, 1});
    run.to(3);
    CHECK(run.state().position.x() == doctest::Approx(1.5).epsilon(1e-9));
    CHECK(length(run.state().velocity) <= 1e-3);
}
