// T10 and T11: bounces, the lowest and the last.
#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

#include "bounds.h"

using namespace laws;
using geometry::dot;

namespace {

// Bounces on a slope that all stick, from a drop of `height` above it along its normal (physics.md 6.1).
struct Bounces {
    double end = 0;    // s, their limit
    double way = 0;    // m, down the slope until then
    double speed = 0;  // m/s, down the slope then
};
Bounces bounces_that_stick(double angle, double height, double restitution) {
    double const normal = g * std::cos(angle), along = g * std::sin(angle), k = 0.5;
    double const fall = std::sqrt(2 * height / normal), up = restitution * normal * fall;
    double const span = 2 * up / (normal * (1 - restitution));
    double const squares = std::pow(2 * up / normal, 2) / (1 - restitution * restitution);
    double const speed = along * fall / (1 + k);
    return {fall + span,
            along * fall * fall / 2 + speed * span + along * span * span / (2 * (1 + k)) +
                along / 2 * k / (1 + k) * squares,
            speed + along * span / (1 + k)};
}

// The same by every single bounce, in long double, whether it sticks or slips; s is the rim's speed in the rolling
// sense.
struct Way {
    double time = 0, along = 0, speed = 0, rim = 0, turned = 0;  // s, m, m/s, m/s, m, when the bounces have ended
};
Way bounced_out(double angle, double height, double restitution, double friction, double rim) {
    long double const normal = g * std::cos(static_cast<long double>(angle));
    long double const pull = g * std::sin(static_cast<long double>(angle)), k = 0.5L, e = restitution;
    long double time = 0, along = 0, speed = 0, s = rim, turned = 0;
    long double hop = std::sqrt(2 * height / normal), closing = normal * hop;
    while (hop > 1e-25L) {
        time += hop;
        along += speed * hop + pull * hop * hop / 2;
        turned += s * hop;
        speed += pull * hop;
        long double const wanted = (speed - s) * k / (1 + k), most = friction * (1 + e) * closing;
        long double const push = std::clamp(wanted, -most, most);
        speed -= push;
        s += push / k;
        closing *= e;
        hop = 2 * closing / normal;
    }
    return {static_cast<double>(time), static_cast<double>(along), static_cast<double>(speed), static_cast<double>(s),
            static_cast<double>(turned)};
}

// The most events within a sixtieth of a second.
long busiest_sixtieth(physics::History const& history) {
    long most = 0;
    std::size_t first = 0;
    for (std::size_t last = 0; last < history.events.size(); ++last) {
        while (history.events[first].time < history.events[last].time - 1.0 / 60) ++first;
        most = std::max(most, static_cast<long>(last - first + 1));
    }
    return most;
}

}  // namespace

TEST_CASE("T10: a ball dropped from h bounces to e^2 h, also from 5 cm") {
    for (Bound const& bound : bounds_of(law::bounce))
        for (double const drop : {0.05, 1.0}) {
            Run run(bound.method, floor_with(disc_at({0, 0.5 + drop}), material(0.9, 0.8)));
            run.to(std::sqrt(2 * drop / g) * 1.3);
            double const energy =
                0.5 * dot(run.state().velocity, run.state().velocity) + g * (run.state().position.y() - 0.5);
            CHECK(energy / g == doctest::Approx(0.64 * drop).epsilon(bound.tolerance));
        }
}

TEST_CASE("T10 pinned: article never bounces, whatever the surface") {
    Run run(physics::Article{}, floor_with(disc_at({0, 1.5}), material(0.9, 0.8)));
    for (int i = 1; i <= 480; ++i) {
        run.to(i / 240.0);
        // It stops where it lands, within the way of a step.
        if (run.world.time > std::sqrt(2 / g) + 1 / 240.0) REQUIRE(run.state().position.y() == 0.5);
    }
    CHECK(run.count(physics::EventKind::bounce) == 0);
}

TEST_CASE("T10: without loss a ball bounces for a minute to the same height") {
    for (Bound const& bound : bounds_of(law::bounce)) {
        Run run(bound.method, floor_with(disc_at({0, 1.5}), material(0, 1)));
        double const start = energy_of(run);
        run.to(60);
        CHECK(energy_of(run) == doctest::Approx(start).epsilon(bound.tolerance));
    }
}

TEST_CASE("T11: bounces that never end come to rest at their limit, after few events") {
    // From 1 m with e = 0.99: sqrt(2h/g) (1+e)/(1-e) = 89.853 s.
    for (Bound const& bound : bounds_of(law::rest_time))
        for (double const height : {1.0, 1.3})
            for (double const e : {0.35, 0.5, 0.8, 0.9, 0.99, 0.999}) {
                CAPTURE(std::string(physics::name_of(bound.method)));
                CAPTURE(height);
                CAPTURE(e);
                double const limit = std::sqrt(2 * height / g) * (1 + e) / (1 - e);
                Run run(bound.method, floor_with(disc_at({0, 0.5 + height}), material(0.9, e)));
                run.to(limit + 1);
                REQUIRE(run.history.events.back().kind == physics::EventKind::rest);
                // 1 - e has lost three digits at 0.999.
                CHECK(run.history.events.back().time ==
                      doctest::Approx(limit).epsilon(e < 0.999 ? bound.tolerance : 100 * bound.tolerance));
                CHECK(run.leg().phase == physics::Phase::rest);
                CHECK(run.state().velocity == Vec2(0, 0));
                CHECK(run.history.events.size() <= (e < 0.999 ? 5000 : 50000));
                CHECK(run.count(physics::EventKind::handover) == 0);
            }
}

TEST_CASE("T11: on a slope the bounces end in rolling, where and when their sums say") {
    double const angle = 0.3, height = 1, e = 0.9;
    Bounces const sum = bounces_that_stick(angle, height, e);
    for (Bound const& bound : bounds_of(law::rest_time)) {
        CAPTURE(std::string(physics::name_of(bound.method)));
        Slope slope = slope_with(angle, disc_at(Vec2::Zero()), material(0.9, e));
        slope.scene.balls[0].start.position += height * slope.normal;
        Run run(bound.method, slope.scene);
        run.to(sum.end + 1);
        double const since = run.world.time - sum.end, a = g * std::sin(angle) / 1.5;
        CHECK(run.leg().phase == physics::Phase::roll);
        CHECK(dot(run.state().velocity, slope.down) == doctest::Approx(sum.speed + a * since).epsilon(bound.tolerance));
        CHECK(dot(run.state().position, slope.down) ==
              doctest::Approx(sum.way + sum.speed * since + a * since * since / 2).epsilon(bound.tolerance));
        CHECK(run.history.events.size() <= 5000);
    }
}

TEST_CASE("T11: where bounces are many in a sixtieth of a second their sum comes early, and comes to the same") {
    // Sticking, slipping all along either way, and without a slope.
    struct Case {
        double angle, friction, rim;
    };
    for (double const e : {0.998, 0.9995})
        for (Case const& c : {Case{0.3, 0.9, 0}, Case{0.3, 0.02, 40}, Case{0.3, 0.02, -40}, Case{0, 0.5, 0}}) {
            CAPTURE(e);
            CAPTURE(c.rim);
            double const height = 1e-6;
            Way const way = bounced_out(c.angle, height, e, c.friction, c.rim);
            Slope slope = slope_with(c.angle, disc_at(Vec2::Zero()), material(c.friction, e));
            physics::Ball& ball = slope.scene.balls[0];
            ball.start.position += height * slope.normal;
            ball.start.spin = -c.rim / ball.radius;
            Run run(physics::Exact{}, slope.scene);
            run.to(way.time);
            CHECK(std::abs(dot(run.state().position, slope.down) - way.along) < 1e-10);
            CHECK(std::abs(dot(run.state().velocity, slope.down) - way.speed) < 1e-10);
            CHECK(std::abs(-ball.radius * run.state().spin - way.rim) < 1e-10);
            CHECK(std::abs(-ball.radius * run.state().angle - way.turned) < 1e-9);
            CHECK(busiest_sixtieth(run.history) < 3000);
        }
}

TEST_CASE("a fast ball in a narrow ring bounces into rolling, and no sixtieth of a second holds thousands of bounces") {
    // Pressed by v^2 / rho, 220,000 m/s^2, it would bounce 10,000 times in 3 ms before its hops are too low to be seen.
    double const ring = 0.058, radius = 0.05;
    physics::Ball ball = disc_at({0.0078, 0}, {3, 42});
    ball.radius = radius;
    Run run(physics::Exact{}, scene_of({arc({0, 0}, ring, 0, 2 * geometry::pi, material(0, 0.999))}, {ball}));
    double const before = energy_of(run);
    run.to(1);
    CHECK(busiest_sixtieth(run.history) < 3000);
    CHECK(energy_of(run) <= before * (1 + 1e-12));
    // Without friction its moment of momentum about the ring's centre stays, but for gravity: 2 g (ring - radius) of
    // v^2.
    CHECK(geometry::length(run.state().velocity) == doctest::Approx(0.0078 * 42 / (ring - radius)).epsilon(1e-4));
    CHECK(geometry::length(run.state().position) < ring - radius + 1e-9);
}
