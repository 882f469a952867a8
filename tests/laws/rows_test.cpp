// T19: many hits at one moment.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include <doctest/doctest.h>

#include "bounds.h"

using namespace laws;
using geometry::length;

namespace {

using Order = std::vector<int>;  // by place in the scene: which ball

physics::Scene without_gravity(std::vector<physics::Ball> balls, double restitution, double friction) {
    for (physics::Ball& ball : balls) {
        ball.restitution = restitution;
        ball.friction = friction;
    }
    return scene_of({}, std::move(balls), 0);
}

// A disc at 5 m/s on its way to the tip of a triangle of fifteen, that touch if `spacing` is 1 (m).
std::vector<physics::Ball> rack(double spacing) {
    std::vector<physics::Ball> balls{disc_at({-4, 0}, {5, 0})};
    for (int row = 0; row < 5; ++row)
        for (int i = 0; i <= row; ++i)
            balls.push_back(disc_at({spacing * row * std::sqrt(0.75), spacing * (i - 0.5 * row)}));
    return balls;
}

// The velocities of the rack's balls after 3 s, by ball whatever their order in the scene.
std::vector<Vec2> broken_rack(physics::Method const& method, physics::Scene const& scene, Order const& order) {
    physics::Scene ordered = scene;
    for (std::size_t i = 0; i < order.size(); ++i) ordered.balls[i] = scene.balls[order[i]];
    Run run(method, ordered);
    run.to(3);
    std::vector<Vec2> velocities(order.size(), Vec2::Zero());
    for (std::size_t i = 0; i < order.size(); ++i) velocities[order[i]] = run.state(static_cast<int>(i)).velocity;
    return velocities;
}

double largest_difference(std::vector<Vec2> const& a, std::vector<Vec2> const& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, length(a[i] - b[i]));
    return largest;
}

// The same velocities with the rack turned over about its axis.
std::vector<Vec2> turned_over(std::vector<Vec2> const& velocities) {
    std::vector<Vec2> over = velocities;
    for (int row = 0; row < 5; ++row)
        for (int i = 0; i <= row; ++i) {
            int const first = 1 + row * (row + 1) / 2;
            Vec2 const& other = velocities[first + row - i];
            over[first + i] = Vec2(other.x(), -other.y());
        }
    over[0].y() = -over[0].y();
    return over;
}

std::vector<Order> orders_of_sixteen() {
    Order as_drawn(16);
    std::iota(as_drawn.begin(), as_drawn.end(), 0);
    Order const reversed(as_drawn.rbegin(), as_drawn.rend());
    Order mixed = as_drawn;
    std::mt19937 random(7);
    for (std::size_t i = 15; i > 0; --i) std::swap(mixed[i], mixed[random() % (i + 1)]);
    return {as_drawn, reversed, mixed};
}

}  // namespace

TEST_CASE(
    "T19: five touching discs pass the blow to the last, in either order of creation, in the air and on a floor") {
    for (Bound const& bound : bounds_of(law::simultaneous))
        for (bool const reversed : {false, true})
            for (bool const on_floor : {false, true}) {
                CAPTURE(std::string(physics::name_of(bound.method)));
                CAPTURE(reversed);
                CAPTURE(on_floor);
                std::vector<physics::Ball> balls{disc_at({-3, 0.5}, {2, 0})};
                for (int i = 0; i < 5; ++i) balls.push_back(disc_at({1.0 * i, 0.5}));
                if (reversed) std::reverse(balls.begin(), balls.end());
                physics::Scene scene = without_gravity(balls, 1, 0);
                if (on_floor) scene = scene_of({line({-50, 0}, {50, 0}, material(0))}, scene.balls);
                Run run(bound.method, scene);
                run.to(2);
                for (int i = 0; i < 6; ++i)
                    CHECK(std::abs(run.state(i).velocity.x() - (i == (reversed ? 0 : 5) ? 2 : 0)) <= bound.tolerance);
                CHECK(run.count(physics::EventKind::handover) == 0);
            }
}

TEST_CASE("T19: a ball that hits two mirrored ones at once sends them off mirrored, and keeps to the axis") {
    // Along the normals (sqrt 3 / 2, +-1 / 2), with e = 1 and equal masses, 4 m/s leave -1/5 of it, and 3/5 and
    // +-sqrt 3 / 5 to each.
    for (Bound const& bound : bounds_of(law::simultaneous)) {
        CAPTURE(std::string(physics::name_of(bound.method)));
        Run run(bound.method, without_gravity({disc_at({-5, 0}, {4, 0}), disc_at({0, 0.5}), disc_at({0, -0.5})}, 1, 0));
        run.to(3);
        CHECK(length(run.state(0).velocity - Vec2(-0.8, 0)) <= bound.tolerance);
        CHECK(length(run.state(1).velocity - Vec2(2.4, 0.8 * std::sqrt(3.0))) <= bound.tolerance);
        CHECK(length(run.state(2).velocity - Vec2(2.4, -0.8 * std::sqrt(3.0))) <= bound.tolerance);
        CHECK(std::abs(run.state(1).velocity.y() + run.state(2).velocity.y()) <= bound.tolerance);
        CHECK(std::abs(run.state(1).position.y() + run.state(2).position.y()) <= bound.tolerance);
    }
}

TEST_CASE("T19: three in a row share the speed as one hit after the other does") {
    // e = 1/2: a hit leaves 1/4 and 3/4 of the difference. 2 | 0 | 0 becomes 1/2 | 3/2 | 0, then 1/2 | 3/8 | 9/8, then
    // 13/32 | 15/32 | 9/8.
    for (Bound const& bound : bounds_of(law::simultaneous)) {
        CAPTURE(std::string(physics::name_of(bound.method)));
        Run run(bound.method, without_gravity({disc_at({-3, 0}, {2, 0}), disc_at({0, 0}), disc_at({1, 0})}, 0.5, 0));
        run.to(3);
        CHECK(run.state(0).velocity.x() == doctest::Approx(13.0 / 32).epsilon(bound.tolerance));
        CHECK(run.state(1).velocity.x() == doctest::Approx(15.0 / 32).epsilon(bound.tolerance));
        CHECK(run.state(2).velocity.x() == doctest::Approx(9.0 / 8).epsilon(bound.tolerance));
    }
}

TEST_CASE("T19: three in a row without restitution end at one speed, and never hang") {
    for (Bound const& bound : bounds_of(law::simultaneous))
        for (double const e : {0.0, 0.05}) {
            CAPTURE(std::string(physics::name_of(bound.method)));
            CAPTURE(e);
            Run run(bound.method, without_gravity({disc_at({-3, 0}, {2, 0}), disc_at({0, 0}), disc_at({1, 0})}, e, 0));
            run.to(3);
            CHECK(std::abs(momentum_of(run).x() - 2) <= bound.tolerance);
            for (int i = 0; i < 3; ++i) CHECK(run.state(i).velocity.x() == doctest::Approx(2.0 / 3).epsilon(1e-9));
            CHECK(run.history.events.size() < 2000);
        }
}

TEST_CASE("T19: a ball struck from both sides at once stays") {
    for (Bound const& bound : bounds_of(law::simultaneous)) {
        Run run(bound.method,
                without_gravity({disc_at({-3, 0}, {2, 0}), disc_at({0, 0}), disc_at({3, 0}, {-2, 0})}, 0.5, 0));
        run.to(3);
        CHECK(run.state(0).velocity.x() == doctest::Approx(-1).epsilon(bound.tolerance));
        CHECK(std::abs(run.state(1).velocity.x()) <= bound.tolerance);
        CHECK(run.state(2).velocity.x() == doctest::Approx(1).epsilon(bound.tolerance));
    }
}

TEST_CASE("T19: a rack of fifteen keeps its momentum, and never gains energy") {
    for (Bound const& bound : bounds_of(law::simultaneous))
        for (double const e : {0.5, 0.9, 1.0})
            for (double const mu : {0.0, 0.3}) {
                CAPTURE(std::string(physics::name_of(bound.method)));
                CAPTURE(e);
                CAPTURE(mu);
                Run run(bound.method, without_gravity(rack(1), e, mu));
                run.to(3);
                CHECK(length(momentum_of(run) - Vec2(5, 0)) <= 5 * bound.tolerance);
                CHECK(energy_of(run) <= 12.5 * (1 + bound.tolerance));
                if (e == 1 && mu == 0) CHECK(energy_of(run) == doctest::Approx(12.5).epsilon(bound.tolerance));
            }
}

TEST_CASE("T19: exact breaks a rack as symmetric as it stood, in whatever order its balls were made") {
    for (double const spacing : {1.0, 1 + 1e-6, 1.001})
        for (double const e : {0.5, 0.9, 1.0})
            for (double const mu : {0.0, 0.3}) {
                CAPTURE(spacing);
                CAPTURE(e);
                CAPTURE(mu);
                physics::Scene const scene = without_gravity(rack(spacing), e, mu);
                std::vector<Order> const orders = orders_of_sixteen();
                std::vector<Vec2> const broken = broken_rack(physics::Exact{}, scene, orders[0]);
                for (Order const& order : orders) {
                    std::vector<Vec2> const again = broken_rack(physics::Exact{}, scene, order);
                    CHECK(largest_difference(again, broken) <= 1e-12);
                    CHECK(largest_difference(again, turned_over(again)) <= 1e-12);
                }
            }
}

TEST_CASE("T19 pinned: article's balls pass through each other, and keep what they had") {
    Run run(physics::Article{}, without_gravity(rack(1), 1, 0));
    run.to(3);
    CHECK(run.state(0).velocity == Vec2(5, 0));
    for (int i = 1; i < 16; ++i) CHECK(run.state(i).velocity == Vec2(0, 0));
}

TEST_CASE("T19: slip that ends as the disc meets a wall is neither skipped nor counted twice") {
    // From 5 m/s without spin on mu = 1/5 it rolls at 5/1.5 from the time k v / ((1 + k) mu g) on. A smooth wall there,
    // or a hair before or after, turns it with e = 1/2 to slide back against its spin.
    double const mu = 0.2, time = 5 / 3.0 / (mu * g), way = 5 * time - 0.5 * mu * g * time * time;
    for (Bound const& bound : bounds_of(law::simultaneous))
        for (double const hair : {0.0, 1e-13, -1e-13, 1e-9, -1e-9}) {
            CAPTURE(std::string(physics::name_of(bound.method)));
            CAPTURE(hair);
            double const wall = way + 0.5 + hair;
            Run run(bound.method,
                    scene_of({line({-9, 0}, {wall, 0}, material(mu)), line({wall, 0}, {wall, 9}, material(0, 0.5))},
                             {disc_at({0, 0.5}, {5, 0})}));
            run.to(time + 0.3);
            double const since = run.world.time - time, slack = std::max(3 * std::abs(hair), bound.tolerance);
            CHECK(std::abs(run.state().velocity.x() - (-0.5 * 5 / 1.5 + mu * g * since)) <= slack);
            CHECK(std::abs(0.5 * run.state().spin - (-5 / 1.5 + mu * g * since / 0.5)) <= slack);
            CHECK(run.leg().phase == physics::Phase::slide);
            CHECK(run.count(physics::EventKind::bounce) == 1);
        }
}
