#include <cmath>
#include <random>

#include <doctest/doctest.h>

#include "bounds.h"
#include "physics/steps_impact.h"
#include "scenes.h"

using namespace laws;
using geometry::dot;
using geometry::length;

namespace {

double kinetic(physics::State const& s, physics::Ball const& b) {
    return 0.5 * b.mass * (dot(s.velocity, s.velocity) + b.inertia * b.radius * b.radius * s.spin * s.spin);
}

}  // namespace

TEST_CASE("no impact gains energy, and slip never turns round") {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> number(-10, 10), share(0, 1);
    for (int i = 0; i < 100000; ++i) {
        physics::Ball ball = disc_at({0, 0.5}, {number(random), number(random)}, number(random));
        ball.inertia = 1e-6 + share(random) * 0.999;
        double const e = share(random), mu = i % 10 == 0 ? full_grip : 2 * share(random);
        physics::State const after = physics::after_impact(ball.start, ball, {0, 1}, e, mu).state;
        REQUIRE(kinetic(after, ball) <= kinetic(ball.start, ball) * (1 + 1e-12));
        double const slip = ball.start.velocity.x() + 0.5 * ball.start.spin,
                     slip_after = after.velocity.x() + 0.5 * after.spin;
        REQUIRE(slip * slip_after >= -1e-12 * slip * slip);
    }
}

TEST_CASE("no impact of two balls gains energy, and momentum and angular momentum are kept") {
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> number(-10, 10), share(0.01, 1);
    for (int i = 0; i < 100000; ++i) {
        double const angle = number(random);
        Vec2 const n(std::cos(angle), std::sin(angle));
        physics::Ball a = disc_at({0, 0}, {number(random), number(random)}, number(random));
        physics::Ball b = disc_at(Vec2::Zero(), {number(random), number(random)}, number(random));
        a.radius = share(random);
        a.mass = 10 * share(random);
        a.inertia = share(random);
        b.friction = share(random);
        b.start.position = (a.radius + b.radius) * n;
        auto const after = physics::after_pair_impact(a.start, a, b.start, b, n, share(random));
        double const before = kinetic(a.start, a) + kinetic(b.start, b);
        REQUIRE(kinetic(after.first, a) + kinetic(after.second, b) <= before * (1 + 1e-12));
        Vec2 const lost =
            a.mass * (after.first.velocity - a.start.velocity) + b.mass * (after.second.velocity - b.start.velocity);
        REQUIRE(length(lost) <= 1e-11 * (1 + before));
        auto const moment = [](physics::Ball const& ball, physics::State const& s) {
            return ball.mass * (geometry::wedge(ball.start.position, s.velocity) +
                                ball.inertia * ball.radius * ball.radius * s.spin);
        };
        double const turned =
            moment(a, after.first) + moment(b, after.second) - moment(a, a.start) - moment(b, b.start);
        REQUIRE(std::abs(turned) <= 1e-11 * (1 + before));
    }
}

TEST_CASE("a ball dropped from h bounces to e^2 h, also from 5 cm") {
    for (Bound const& bound : bounds_of(Law::bounce))
        for (double const drop : {0.05, 1.0}) {
            Run run(bound.method, floor_with(disc_at({0, 0.5 + drop}), material(0.9, 0.8)));
            run.to(std::sqrt(2 * drop / g) * 1.3);
            double const energy =
                0.5 * dot(run.state().velocity, run.state().velocity) + g * (run.state().position.y() - 0.5);
            CHECK(energy / g == doctest::Approx(0.64 * drop).epsilon(bound.tolerance));
        }
}

TEST_CASE("without loss a ball bounces for ten minutes to the same height") {
    for (Bound const& bound : bounds_of(Law::bounce)) {
        Run run(bound.method, floor_with(disc_at({0, 1.5}), material(0, 1)));
        double const start = energy_of(run);
        run.to(60);
        CHECK(energy_of(run) == doctest::Approx(start).epsilon(bound.tolerance));
    }
}

TEST_CASE("a bounce sequence ends in rest at its limit time") {
    for (Bound const& bound : bounds_of(Law::bounce)) {
        Run run(bound.method, floor_with(disc_at({0, 1.5}), material(0.9, 0.5)));
        run.to(5);
        double const limit = std::sqrt(2 * 1.0 / g) * 1.5 / 0.5;
        CHECK(run.leg().phase == physics::Phase::rest);
        for (physics::Event const& event : run.history.events)
            if (event.kind == physics::EventKind::rest) CHECK(event.time == doctest::Approx(limit).epsilon(0.02));
    }
}

TEST_CASE("a disc rolling into a wall climbs it at v / 3") {
    auto const grip = material(full_grip);
    for (Bound const& bound : bounds_of(Law::corner)) {
        Run run(bound.method, scene_of({line({-9, 0}, {0, 0}, grip), line({0, 0}, {0, 9}, grip)},
                                       {disc_at({-1.5, 0.5}, {2, 0}, -4)}));
        run.to(0.55);
        double const since = run.world.time - 0.5;
        CHECK(run.state().velocity.y() == doctest::Approx(2.0 / 3 - g * since).epsilon(bound.tolerance));
    }
}

TEST_CASE("article: at a wall the ball stops dead") {
    auto const grip = material(full_grip);
    Run run(physics::Article{},
            scene_of({line({-9, 0}, {0, 0}, grip), line({0, 0}, {0, 9}, grip)}, {disc_at({-1.5, 0.5}, {2, 0}, -4)}));
    run.to(1);
    CHECK(length(run.state().velocity) <= 1e-9);
    CHECK(run.state().position.x() == doctest::Approx(-0.5));
}

TEST_CASE("a disc climbs a step from the speed that the notes ask for, and not below") {
    auto const grip = material(full_grip);
    double const least = 1.31963;  // m/s, physics.md 2.11: r = 0.5, h = 0.1
    for (Bound const& bound : bounds_of(Law::corner))
        for (double const share : {0.995, 1.005}) {
            double const speed = share * least;
            Run run(bound.method, scene_of({line({-9, 0}, {0, 0}, grip), line({0, 0}, {0, 0.1}, grip),
                                            line({0, 0.1}, {9, 0.1}, grip)},
                                           {disc_at({-1.5, 0.5}, {speed, 0}, -speed / 0.5)}));
            run.to(6);
            CHECK((run.state().position.x() > 0) == (share > 1));
        }
}

TEST_CASE("two discs that hit keep their momentum, and part at e times the speed at which they met") {
    for (Bound const& bound : bounds_of(Law::pair_momentum)) {
        physics::Ball a = disc_at({0, 0}, {3, 0}), b = disc_at({4, 0}, {-1, 0});
        a.friction = b.friction = 0;
        a.restitution = 0.2;
        b.restitution = 0.7;
        b.mass = 2.5;
        physics::Scene scene = scene_of({}, {a, b});
        scene.gravity = 0;
        Run run(bound.method, scene);
        run.to(2);
        CHECK(run.state(0).velocity.x() + 2.5 * run.state(1).velocity.x() ==
              doctest::Approx(0.5).epsilon(bound.tolerance));
        CHECK(run.state(1).velocity.x() - run.state(0).velocity.x() ==
              doctest::Approx(0.7 * 4).epsilon(bound.tolerance));
        double const since = run.world.time - 0.75;
        CHECK(run.state(0).position.x() == doctest::Approx(2.25 + since * run.state(0).velocity.x()).epsilon(1e-9));
        CHECK(count_of(run.history, physics::EventKind::hit) == 1);
    }
}

TEST_CASE("in a row of five touching discs the last one leaves with the speed of the first") {
    for (Bound const& bound : bounds_of(Law::pair_momentum)) {
        std::vector<physics::Ball> balls;
        for (int i = 0; i < 5; ++i) balls.push_back(disc_at({i + (i > 0 ? 1.0 : 0.0), 0}));
        for (physics::Ball& ball : balls) {
            ball.restitution = 1;
            ball.friction = 0;
        }
        balls[0].start.velocity = {2, 0};
        physics::Scene scene = scene_of({}, balls);
        scene.gravity = 0;
        Run run(bound.method, scene);
        run.to(2);
        for (int i = 0; i < 4; ++i) CHECK(std::abs(run.state(i).velocity.x()) <= 1e-12);
        CHECK(run.state(4).velocity.x() == doctest::Approx(2).epsilon(bound.tolerance));
    }
}

TEST_CASE("no ball gets through a line, at any speed or angle") {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> share(0, 1);
    for (int i = 0; i < 1000; ++i) {
        double const speed = std::pow(10.0, 4 * share(random)), angle = pi * (0.001 + 0.998 * share(random));
        Vec2 const way(std::cos(angle), -std::sin(angle));
        physics::Ball const ball = disc_at({0, 0.6 + 2 * share(random)}, speed * way);
        physics::Scene scene = scene_of({line({-1e6, 0}, {1e6, 0}, material(0.9, i % 2 == 0 ? 0.0 : 0.7))}, {ball});
        Run run(physics::Steps{}, scene);
        run.to(4.0 / 240);
        REQUIRE(run.state().position.y() >= 0.5 - 1e-9);
    }
}

TEST_CASE("no fast ball leaves a closed ring, nor gets past a small one's end unseen") {
    std::mt19937_64 random(4);
    std::uniform_real_distribution<double> share(0, 1);
    for (int i = 0; i < 200; ++i) {
        double const speed = std::pow(10.0, 4 * share(random)), angle = 2 * pi * share(random);
        physics::Ball const ball =
            disc_at({share(random), share(random)}, speed * Vec2(std::cos(angle), std::sin(angle)));
        Run run(physics::Steps{}, scene_of({arc({0, 0}, 3, 0, 2 * pi, material(0.5, 0.8))}, {ball}));
        run.to(0.1);
        REQUIRE(length(run.state().position) <= 2.5 + 1e-6);
    }
}

TEST_CASE("two fast balls never pass through each other") {
    for (double const speed : {10.0, 1000.0, 10000.0}) {
        physics::Scene scene = scene_of({}, {disc_at({0, 0}, {speed, 0}), disc_at({1.2 + speed * 0.0101, 0.2})});
        scene.gravity = 0;
        Run run(physics::Steps{}, scene);
        run.to(0.05);
        CHECK(run.state(1).position.x() > run.state(0).position.x());
        CHECK(count_of(run.history, physics::EventKind::hit) == 1);
    }
}

TEST_CASE("article: above r per step a ball falls through the floor, as its readers found") {
    physics::Scene const scene = floor_with(disc_at({0, 3}, {0, -400}), material(0.9));
    CHECK(state_after(physics::Article{60}, scene, 0.1).position.y() < 0);
    CHECK(state_after(physics::Steps{60, 4}, scene, 0.1).position.y() >= 0.5 - 1e-9);
}
