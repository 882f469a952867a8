#include <algorithm>
#include <cmath>
#include <random>

#include <doctest/doctest.h>

#include "bounds.h"
#include "physics/steps/ball_impacts.h"

using namespace laws;
using geometry::length;

namespace {

// A disc that meets a floor without gravity, and what it must leave with (physics.md 1.2).
struct Hit {
    physics::Scene scene;
    double tangent = 0;  // m/s
    double rim = 0;      // m/s, in the rolling sense
    double normal = 0;   // m/s
};
Hit random_hit(std::mt19937_64& random) {
    std::uniform_real_distribution<double> number(-10, 10), share(0, 1);
    double const down = -10 * share(random), along = number(random), rim = number(random);
    double const e = share(random), mu = share(random) < 0.1 ? full_grip : 2 * share(random);
    double const k = 1e-6 + share(random) * 0.999;
    physics::Ball ball = disc_at({0, 0.5 + 1e-3}, {along, down}, -rim / 0.5);
    ball.inertia = k;
    Hit hit{floor_with(ball, material(mu, e), 0), 0, 0, -e * down};
    double const most = mu * -(1 + e) * down, wanted = -(along - rim) * k / (1 + k);
    double const impulse = std::clamp(wanted, -most, most);
    hit.tangent = along + impulse;
    hit.rim = rim - impulse / k;
    return hit;
}

}  // namespace

TEST_CASE("T1: no impact gains energy, and each leaves what mechanics says") {
    for (Bound const& bound : bounds_of(law::impact_energy)) {
        CAPTURE(std::string(physics::name_of(bound.method)));
        std::mt19937_64 random(1);
        for (int i = 0; i < (sanitized ? 5'000 : 100'000); ++i) {
            Hit const hit = random_hit(random);
            Run run(bound.method, hit.scene);
            double const before = energy_of(run);
            while (run.history.events.empty() && run.world.time < 10) run.to(run.world.time + 1 / 60.0);
            REQUIRE(energy_of(run) <= before * (1 + bound.tolerance));
            // Speeds of up to 20 m/s and, with k of 1e-6, spins of up to 1e7 rad/s.
            double const k = hit.scene.balls[0].inertia;
            REQUIRE(std::abs(run.state().velocity.x() - hit.tangent) <= 20 * bound.tolerance);
            REQUIRE(std::abs(run.state().velocity.y() - hit.normal) <= 20 * bound.tolerance);
            REQUIRE(std::abs(-0.5 * run.state().spin - hit.rim) <= 20 * bound.tolerance / k);
        }
    }
}

TEST_CASE("T1 pinned: article pays nothing for spin: a hit changes the energy along the floor by k (v^2 - s^2) / 2") {
    std::mt19937_64 random(1);
    int gained = 0, hits = 0;
    for (int i = 0; i < 10'000; ++i) {
        Hit const hit = random_hit(random);
        physics::State const& start = hit.scene.balls[0].start;
        Run run(physics::Article{}, hit.scene);
        double const before = energy_of(run), k = hit.scene.balls[0].inertia;
        double const along = start.velocity.x(), rim = -0.5 * start.spin, down = start.velocity.y();
        run.to(0.1);
        if (down > -0.02) continue;  // it has not come down yet
        ++hits;
        double const change = 0.5 * k * (along * along - rim * rim) - 0.5 * down * down;
        REQUIRE(energy_of(run) - before == doctest::Approx(change).epsilon(1e-12).scale(100));
        REQUIRE(energy_of(run) <= before * (1 + k + 1e-12));
        gained += energy_of(run) > before;
    }
    CHECK(gained / static_cast<double>(hits) == doctest::Approx(0.17).epsilon(0.05));
}

TEST_CASE("T1: steps: no impact of two balls gains energy, and momentum and angular momentum are kept") {
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> number(-10, 10), share(0.01, 1);
    for (int i = 0; i < 100000; ++i) {
        double const angle = number(random);
        Vec2 const n(std::cos(angle), std::sin(angle));
        physics::Ball a = disc_at({0, 0}, {number(random), number(random)}, number(random));
        physics::Ball b = disc_at({0, 0}, {number(random), number(random)}, number(random));
        a.radius = share(random);
        a.mass = 10 * share(random);
        a.inertia = share(random);
        b.friction = share(random);
        b.start.position = (a.radius + b.radius) * n;
        auto const after = physics::after_pair_impact(a.start, a, b.start, b, n, share(random));
        double const before = kinetic_energy(a, a.start) + kinetic_energy(b, b.start);
        REQUIRE(kinetic_energy(a, after.first) + kinetic_energy(b, after.second) <= before * (1 + 1e-12));
        Vec2 const lost =
            a.mass * (after.first.velocity - a.start.velocity) + b.mass * (after.second.velocity - b.start.velocity);
        REQUIRE(length(lost) <= 1e-11 * (1 + before));
        auto const moment = [](physics::Ball const& ball, physics::State const& s) {
            return ball.mass * (geometry::cross(ball.start.position, s.velocity) +
                                ball.inertia * ball.radius * ball.radius * s.spin);
        };
        double const turned =
            moment(a, after.first) + moment(b, after.second) - moment(a, a.start) - moment(b, b.start);
        REQUIRE(std::abs(turned) <= 1e-11 * (1 + before));
    }
}

TEST_CASE("two discs that hit keep their momentum, and part at e times the speed at which they met") {
    for (Bound const& bound : bounds_of(law::pair_momentum)) {
        physics::Ball a = disc_at({0, 0}, {3, 0}), b = disc_at({4, 0}, {-1, 0});
        a.friction = b.friction = 0;
        a.restitution = 0.2;
        b.restitution = 0.7;
        b.mass = 2.5;
        Run run(bound.method, scene_of({}, {a, b}, 0));
        run.to(2);
        CHECK(run.state(0).velocity.x() + 2.5 * run.state(1).velocity.x() ==
              doctest::Approx(0.5).epsilon(bound.tolerance));
        CHECK(run.state(1).velocity.x() - run.state(0).velocity.x() ==
              doctest::Approx(0.7 * 4).epsilon(bound.tolerance));
        double const since = run.world.time - 0.75;
        CHECK(run.state(0).position.x() == doctest::Approx(2.25 + since * run.state(0).velocity.x()).epsilon(1e-9));
        CHECK(run.count(physics::EventKind::hit) == 1);
    }
}
