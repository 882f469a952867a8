#include <doctest/doctest.h>

#include "stages.h"
#include "view/overlay.h"

using view::Vec2;
using namespace view_test;

TEST_CASE("the figures are those of the article") {
    level::Level const level = floor_level(16, 9);
    physics::State state;
    state.position = Vec2(5, 1.5);
    state.velocity = Vec2(3, -2);
    view::Moment const moment = view::moment_at(level, steady_history(state), 0);
    auto const figures = view::figures_of(level, moment, 0);
    REQUIRE(figures);
    // n = (0, 1): t = v - (v.n) n = (3, 0), L = v ^ n = 3 * 1 - (-2) * 0 = 3, theta = L / r = 3 / 0.5.
    CHECK(geometry::length(figures->normal - Vec2(0, 1)) < 1e-12);
    CHECK(geometry::length(figures->contact - Vec2(5, 1)) < 1e-12);
    CHECK(geometry::length(figures->kept - Vec2(3, 0)) < 1e-12);
    CHECK(figures->length == doctest::Approx(3).epsilon(1e-12));
    CHECK(figures->roll == doctest::Approx(6).epsilon(1e-12));
}

TEST_CASE("high above the ground there are no figures") {
    level::Level const level = floor_level(16, 9);
    physics::State state;
    state.position = Vec2(5, 7);
    CHECK(!view::figures_of(level, view::moment_at(level, steady_history(state), 0), 0));
}

TEST_CASE("energy is that of motion, rotation, height and spring") {
    level::Level level = floor_level(16, 9);
    level.scene.balls[0].mass = 2;
    level.scene.drag.frequency = 1;
    physics::State state;
    state.position = Vec2(5, 3);
    state.velocity = Vec2(3, 4);
    state.spin = 6;
    physics::Forces forces;
    forces.pull = physics::Pull{0, Vec2(5, 3.5)};
    view::Energy const energy = view::energy_of(level, {state}, forces);
    CHECK(energy.motion == doctest::Approx(2 * 25 / 2.0));
    // I = k m r^2 = 0.5 * 2 * 0.25, and I w^2 / 2 = 0.25 * 36 / 2.
    CHECK(energy.rotation == doctest::Approx(4.5));
    CHECK(energy.height == doctest::Approx(2 * 9.81 * 3));
    // (2 pi)^2 is 39.4784176; times m s^2 / 2 = 2 * 0.25 / 2.
    CHECK(energy.spring == doctest::Approx(9.8696044).epsilon(1e-8));
}

TEST_CASE("a list of overlays is read word by word") {
    CHECK(view::overlays_from("figures,energy") == view::Overlays{true, false, true});
    CHECK(view::overlays_from("all") == view::Overlays{true, true, true});
    CHECK(!view::overlays_from("figure"));
    CHECK(!view::overlays_from(""));
    CHECK(!view::overlays_from("forces,"));
    CHECK(!view::overlays_from("forces,,energy"));
}
