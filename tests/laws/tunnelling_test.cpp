// T6: nothing passes through anything, however fast.
#include <cmath>
#include <random>

#include <doctest/doctest.h>

#include "bounds.h"

using namespace laws;
using geometry::length;

namespace {

// A ball above a floor of no thickness, on its way down at 1 to 1e5 m/s under any angle.
physics::Scene falling_on_a_line(std::mt19937_64& random, double gravity) {
    std::uniform_real_distribution<double> share(0, 1);
    double const speed = std::pow(10.0, 5 * share(random)), angle = pi * (0.001 + 0.998 * share(random));
    physics::Ball const ball = disc_at({0, 0.6 + 2 * share(random)}, speed * Vec2(std::cos(angle), -std::sin(angle)));
    double const restitution = share(random) < 0.5 ? 0 : 0.7;
    return scene_of({line({-1e6, 0}, {1e6, 0}, material(0.9, restitution))}, {ball}, gravity);
}

}  // namespace

TEST_CASE("T6: no ball gets through a line, at any speed or angle") {
    int const cases = sanitized ? 5'000 : 100'000;
    for (Bound const& bound : bounds_of(law::no_escape)) {
        CAPTURE(std::string(physics::name_of(bound.method)));
        std::mt19937_64 random(3);
        for (int i = 0; i < cases; ++i) {
            Run run(bound.method, falling_on_a_line(random, i % 2 == 0 ? 0 : g));
            for (double const time : {4.0 / 60, 1.0}) {
                run.to(time);
                REQUIRE(run.state().position.y() >= 0.5 - bound.tolerance);
            }
        }
    }
}

TEST_CASE("T6 pinned: article lets a ball through where a step takes its centre past the line from beyond its radius") {
    // The step sees the ball where it ends: without gravity at y0 - n fall / rate.
    double const rate = 60;
    std::mt19937_64 random(3);
    int escaped = 0;
    for (int i = 0; i < 10'000; ++i) {
        physics::Scene const scene = falling_on_a_line(random, 0);
        physics::State const& start = scene.balls[0].start;
        double y = start.position.y();
        while (y > 0.5) y += start.velocity.y() / rate;
        Run run(physics::Article{rate}, scene);
        run.to((start.position.y() - y) / -start.velocity.y() + 2 / rate);
        REQUIRE((run.state().position.y() < 0) == (y < 0));
        escaped += y < 0;
        if (-start.velocity.y() < 0.5 * rate) REQUIRE(y >= 0);
    }
    CHECK(escaped > 3'000);
}

TEST_CASE("T6 pinned: article: the ball falls through the floor, as its readers found") {
    physics::Scene const scene = floor_with(disc_at({0, 3}, {0, -400}), material(0.9));
    CHECK(state_after(physics::Article{60}, scene, 0.1).position.y() < 0);
    CHECK(state_after(physics::Steps{60, 4}, scene, 0.1).position.y() >= 0.5 - 1e-9);
}

TEST_CASE("T6: no fast ball leaves a closed ring") {
    for (Bound const& bound : bounds_of(law::no_escape)) {
        CAPTURE(std::string(physics::name_of(bound.method)));
        std::mt19937_64 random(4);
        std::uniform_real_distribution<double> share(0, 1);
        for (int i = 0; i < 200; ++i) {
            double const speed = std::pow(10.0, 4 * share(random)), angle = 2 * pi * share(random);
            physics::Ball const ball =
                disc_at({share(random), share(random)}, speed * Vec2(std::cos(angle), std::sin(angle)));
            Run run(bound.method, scene_of({arc({0, 0}, 3, 0, 2 * pi, material(0.5, 0.8))}, {ball}));
            run.to(0.1);
            REQUIRE(length(run.state().position) <= 2.5 + 1e3 * bound.tolerance);
        }
    }
}

TEST_CASE("T6: two fast balls never pass through each other") {
    for (Bound const& bound : bounds_of(law::no_escape))
        for (double const speed : {10.0, 1000.0, 10000.0}) {
            CAPTURE(std::string(physics::name_of(bound.method)));
            CAPTURE(speed);
            Run run(bound.method, scene_of({}, {disc_at({0, 0}, {speed, 0}), disc_at({1.2 + speed * 0.0101, 0.2})}, 0));
            run.to(0.05);
            CHECK(run.state(1).position.x() > run.state(0).position.x());
            CHECK(run.count(physics::EventKind::hit) == 1);
        }
}

TEST_CASE("T6 pinned: article knows of no other ball") {
    Run run(physics::Article{}, scene_of({}, {disc_at({0, 0}, {3, 0}), disc_at({2, 0})}, 0));
    run.to(1);
    CHECK(run.state(0).position.x() == doctest::Approx(3).epsilon(1e-12));
    CHECK(run.state(1).position.x() == 2);
}
