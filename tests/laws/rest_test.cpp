#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

#include "bounds.h"
#include "scenes.h"

using namespace laws;
using geometry::length;

namespace {

physics::Scene column(std::vector<double> const& masses) {
    std::vector<physics::Ball> balls;
    for (std::size_t i = 0; i < masses.size(); ++i) {
        balls.push_back(disc_at({0, 0.5 + static_cast<double>(i)}));
        balls.back().mass = masses[i];
    }
    return scene_of({line({-50, 0}, {50, 0}, material(0.9))}, balls);
}

double deepest_overlap(Run const& run) {
    double deepest = 0;
    for (std::size_t i = 0; i < run.scene.balls.size(); ++i) {
        double const r = run.scene.balls[i].radius;
        Vec2 const p = run.state(static_cast<int>(i)).position;
        deepest = std::max(deepest, r - p.y());
        for (std::size_t j = 0; j < i; ++j)
            deepest =
                std::max(deepest, r + run.scene.balls[j].radius - length(p - run.state(static_cast<int>(j)).position));
    }
    return deepest;
}

double fastest(Run const& run) {
    double most = 0;
    for (std::size_t i = 0; i < run.scene.balls.size(); ++i)
        most = std::max(most, length(run.state(static_cast<int>(i)).velocity));
    return most;
}

}  // namespace

TEST_CASE("a ball that rests in a groove, on a floor or on a slope stays for ten minutes") {
    auto const grip = material(0.9, 0, 0.05);
    physics::Scene const groove =
        scene_of({line({-2, 2}, {0, 0}, grip), line({0, 0}, {2, 2}, grip)}, {disc_at({0, std::sqrt(0.5) + 0.01})});
    physics::Scene const flat = floor_with(disc_at({0, 0.52}), grip);
    physics::Scene const slope = slope_with(0.04, disc_at(Vec2::Zero()), grip).scene;
    for (physics::Scene const& scene : {groove, flat, slope}) {
        Run run(physics::Steps{}, scene);
        run.to(5);
        Vec2 const place = run.state().position;
        run.to(605);
        CHECK(length(run.state().velocity) <= 1e-4);
        CHECK(length(run.state().position - place) <= 1e-3 * 0.5);
        CHECK(run.leg().phase == physics::Phase::rest);
    }
}

TEST_CASE("spin in a symmetric groove falls at mu g / (k (1 + mu^2) cos)") {
    double const mu = 0.5;
    for (Bound const& bound : bounds_of(Law::groove)) {
        auto const of = material(mu);
        Run run(bound.method, scene_of({line({-2, 2}, {0, 0}, of), line({0, 0}, {2, 2}, of)},
                                       {disc_at({0, std::sqrt(0.5)}, {0, 0}, 20)}));
        run.to(0.3);
        double const fall = mu * g / (0.5 * (1 + mu * mu) * std::sqrt(0.5));
        CHECK(0.5 * run.state().spin == doctest::Approx(10 - fall * 0.3).epsilon(bound.tolerance));
    }
}

TEST_CASE("columns of 10, 20 and 50 discs stand, a little pressed together") {
    struct Case {
        std::size_t count;
        double overlap;  // share of 2r, physics.md T13
    };
    for (Case const c : {Case{10, 0.006}, Case{20, 0.012}, Case{50, 0.03}}) {
        Run run(physics::Steps{}, column(std::vector<double>(c.count, 1.0)));
        run.to(4);
        CHECK(deepest_overlap(run) <= c.overlap);
        CHECK(fastest(run) <= 1e-3);
    }
}

TEST_CASE("a heavy disc on a light one does not press through") {
    struct Case {
        double mass;
        double overlap;  // share of 2r, physics.md T14
    };
    for (Case const c : {Case{100, 0.03}, Case{400, 0.12}}) {
        Run run(physics::Steps{}, column({1, c.mass}));
        run.to(4);
        CHECK(deepest_overlap(run) <= c.overlap);
        CHECK(run.state(1).position.y() > 1.2);
    }
}

TEST_CASE("a light disc from which a load is taken does not jump") {
    physics::Scene scene = column({1, 100});
    Run run(physics::Steps{}, scene);
    run.to(2);
    run.pull(1, {0, 6});
    double highest = 0;
    for (int i = 0; i < 60; ++i) {
        run.to(2 + i / 60.0);
        highest = std::max(highest, run.state(0).position.y());
    }
    CHECK(highest <= 0.5 + 0.02 * 0.5);
}

TEST_CASE("a heap of thirty comes to rest inside its box, and wakes when the box is tilted") {
    auto const of = material(0.6);
    std::vector<physics::Ball> balls;
    for (int i = 0; i < 30; ++i) balls.push_back(disc_at({1 + 1.1 * (i % 5) + 0.03 * (i / 5), 1 + 1.1 * (i / 5)}));
    physics::Scene const box =
        scene_of({line({0, 0}, {7, 0}, of), line({0, 0}, {0, 20}, of), line({7, 0}, {7, 20}, of)}, balls);
    Run run(physics::Steps{}, box);
    run.to(15);
    CHECK(fastest(run) <= 1e-3);
    CHECK(deepest_overlap(run) <= 0.01);
    physics::Forces tilted;
    tilted.tilt = 0.4;
    physics::apply(run.method, run.scene, run.world, tilted, run.history);
    double most = 0;
    for (int i = 1; i <= 60; ++i) {
        run.to(15 + i / 60.0);
        most = std::max(most, fastest(run));
    }
    CHECK(most > 1e-2);
    for (int i = 0; i < 30; ++i) {
        Vec2 const p = run.state(i).position;
        CHECK(p.x() > 0.45);
        CHECK(p.x() < 6.55);
        CHECK(p.y() > 0.45);
    }
}

TEST_CASE("extreme but lawful numbers stay numbers") {
    for (double const radius : {1e-6, 1e-3, 1e3, 1e6})
        for (double const speed : {0.0, 1.0, 1e6})
            for (double const inertia : {1e-6, 1.0}) {
                physics::Ball ball = disc_at({0, 1.5 * radius}, {speed, -speed}, speed);
                ball.radius = radius;
                ball.inertia = inertia;
                ball.mass = 1e6;
                physics::Ball light = ball;
                light.mass = 1e-6;
                light.start.position.x() = 2.1 * radius;
                auto const of = material(full_grip, 0.99, 0.1);
                double const w = 4 * radius;
                physics::Scene const scene =
                    scene_of({line({-w, 0}, {w, 0}, of), arc({0, w}, w, -pi / 2, 2 * pi, of)}, {ball, light});
                for (physics::Method const& method :
                     {physics::Method(physics::Steps{}), physics::Method(physics::Article{})}) {
                    Run run(method, scene);
                    run.pull(0, {1, 1});
                    run.to(0.1);
                    for (int i = 0; i < 2; ++i) {
                        CHECK(geometry::is_finite(run.state(i).position));
                        CHECK(geometry::is_finite(run.state(i).velocity));
                        CHECK(std::isfinite(run.state(i).angle + run.state(i).spin));
                    }
                }
            }
}
