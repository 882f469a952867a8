#include <cmath>

#include <doctest/doctest.h>

#include "bounds.h"

using namespace laws;
using geometry::dot;

namespace {

double way_down(Slope const& slope, physics::State const& state) {
    return dot(state.position - 0.5 * slope.normal, slope.down);
}

}  // namespace

TEST_CASE("a ball in flight follows a parabola and keeps its spin") {
    for (Bound const& bound : bounds_of(law::flight)) {
        physics::State const state = state_after(bound.method, scene_of({}, {disc_at({1, 2}, {3, 4}, 5)}), 2);
        CHECK(state.position.x() == doctest::Approx(1 + 3 * 2).epsilon(bound.tolerance));
        CHECK(state.position.y() == doctest::Approx(2 + 4 * 2 - 0.5 * g * 4).epsilon(bound.tolerance));
        CHECK(state.angle == doctest::Approx(10).epsilon(bound.tolerance));
    }
}

TEST_CASE("T1: a ball on a slope rolls at g sin / (1 + k)") {
    for (Bound const& bound : bounds_of(law::roll_on_slope))
        for (double const k : {0.5, 0.4, 1.0, 1e-6}) {
            physics::Ball ball = disc_at({0, 0});
            ball.inertia = k;
            Slope const slope = slope_with(pi / 6, ball, material(0.9));
            physics::State const state = state_after(bound.method, slope.scene, 2);
            double const way = g * 0.5 / (1 + k) * 2;
            CHECK(way_down(slope, state) == doctest::Approx(way).epsilon(bound.tolerance));
            CHECK(state.angle == doctest::Approx(-way / ball.radius).epsilon(bound.tolerance));
            CHECK(dot(state.position, slope.normal) == doctest::Approx(0.5).epsilon(bound.tolerance));
        }
}

TEST_CASE("T1 pinned: article: a disc on a slope gains as a frictionless one, 9.89 m in 2 s in place of 6.54 m") {
    Slope const slope = slope_with(pi / 6, disc_at(Vec2::Zero()), material(0.9));
    for (double const rate : {60.0, 240.0}) {
        physics::State const state = state_after(physics::Article{rate}, slope.scene, 2);
        // g sin 30 t^2 / 2, and the half step that semi-implicit steps are ahead (physics.md 2.1).
        CHECK(way_down(slope, state) == doctest::Approx(0.5 * g * (2 + 1 / rate)).epsilon(1e-12));
    }
}

TEST_CASE("beyond tan = mu (1 + k) / k a disc slides at g (sin - mu cos)") {
    double const angle = 1.1, mu = 0.3;
    for (Bound const& bound : bounds_of(law::slide_on_slope)) {
        Slope const slope = slope_with(angle, disc_at(Vec2::Zero()), material(mu));
        physics::State const state = state_after(bound.method, slope.scene, 1.5);
        double const a = g * (std::sin(angle) - mu * std::cos(angle));
        CHECK(way_down(slope, state) == doctest::Approx(0.5 * a * 2.25).epsilon(bound.tolerance));
        CHECK(state.spin == doctest::Approx(-mu * g * std::cos(angle) / 0.5 * 1.5 / 0.5).epsilon(bound.tolerance));
    }
}

TEST_CASE("a ball that starts sliding on a floor ends rolling at v0 / (1 + k)") {
    for (Bound const& bound : bounds_of(law::slip_to_roll))
        for (double const k : {0.5, 0.4, 1.0}) {
            double const mu = 0.2, v0 = 5;
            physics::Ball ball = disc_at({0, 0.5}, {v0, 0});
            ball.inertia = k;
            Run run(bound.method, floor_with(ball, material(mu)));
            double const time = v0 * k / (1 + k) / (mu * g);
            run.to(4);
            double const slid = v0 * time - 0.5 * mu * g * time * time;
            CHECK(run.state().velocity.x() == doctest::Approx(v0 / (1 + k)).epsilon(bound.tolerance));
            CHECK(run.state().position.x() ==
                  doctest::Approx(slid + v0 / (1 + k) * (run.world.time - time)).epsilon(bound.tolerance));
            CHECK(run.leg().phase == physics::Phase::roll);
            CHECK(run.count(physics::EventKind::grip) == 1);
        }
}

TEST_CASE("back-spin sends a disc back: v = (v0 - k r w) / (1 + k)") {
    for (Bound const& bound : bounds_of(law::spin_down)) {
        physics::State const state =
            state_after(bound.method, floor_with(disc_at({0, 0.5}, {1, 0}, 20), material(0.4)), 3);
        CHECK(state.velocity.x() == doctest::Approx((1 - 0.5 * 10) / 1.5).epsilon(bound.tolerance));
        CHECK(state.spin == doctest::Approx(-state.velocity.x() / 0.5).epsilon(bound.tolerance));
    }
}

TEST_CASE("rolling resistance stops a disc after v^2 (1 + k) / (2 c g), and it stays") {
    for (Bound const& bound : bounds_of(law::rolling_resistance)) {
        double const c = 0.05;
        Run run(bound.method, floor_with(disc_at({0, 0.5}, {2, 0}, -4), material(0.9, 0, c)));
        run.to(10);
        CHECK(run.state().position.x() == doctest::Approx(4 * 1.5 / (2 * c * g)).epsilon(bound.tolerance));
        CHECK(run.state().velocity == Vec2(0, 0));
        CHECK(run.leg().phase == physics::Phase::rest);
        CHECK(run.count(physics::EventKind::rest) == 1);
    }
}

TEST_CASE("full grip without pressure is no friction") {
    for (Bound const& bound : bounds_of(law::flight)) {
        physics::State const state =
            state_after(bound.method, floor_with(disc_at({0, 0.5}, {1, 0}, 7), material(full_grip), 0), 1);
        CHECK(state.velocity.x() == doctest::Approx(1).epsilon(bound.tolerance));
        CHECK(state.spin == doctest::Approx(7).epsilon(bound.tolerance));
    }
}

TEST_CASE("full grip finds no hold on a wall that is upright but for the rounding of its ends") {
    for (double const lean : {0.0, 2e-15, -2e-15, 1e-14}) {
        CAPTURE(lean);
        // It is thrown up along the wall, which it touches.
        Run run = exact_run({line({16, 0}, {16 + lean, 9}, material(full_grip))}, {disc_at({15.5, 8}, {0, 3})});
        run.to(1);
        CHECK(run.leg().phase == physics::Phase::flight);
        CHECK(run.state().spin == 0);
        CHECK(run.state().position.y() == doctest::Approx(8 + 3 - g / 2).epsilon(1e-14));
    }
}

TEST_CASE(
    "a ball dropped on a joint that all but goes straight on does not fall through, wherever on it it comes down") {
    // Beyond the foot of one line by r times a part of the turn, and not yet above the other: the vertex must be met
    // there.
    for (double turn = 1e-13; turn < 1e-4; turn *= 3)
        for (double const radius : {0.05, 0.5, 30.0})
            for (int place = -2; place <= 12; ++place) {
                CAPTURE(turn);
                CAPTURE(radius);
                CAPTURE(place);
                Run run = exact_run(chain({{-99, 0}, {0, 0}, {99, -99 * turn}}, material(0)),
                                    {disc(radius, {radius * turn * place / 10, radius + 0.3})});
                run.to(1);
                for (int i = 0; i <= 100; ++i)
                    REQUIRE(physics::state_at(run.history, 0, i / 100.0).position.y() > radius - 2e-9 - 2 * turn);
            }
}

TEST_CASE("T8: a thousand flat joints are no bump") {
    std::vector<Vec2> joints;
    for (int i = -5; i <= 1000; ++i) joints.push_back({0.05 * i, 0});
    for (Bound const& bound : bounds_of(law::flat_joints)) {
        Run run(bound.method, scene_of(chain(joints, material(0.9)), {rolling({0, 0.5}, 10)}));
        run.to(4);
        CHECK(std::abs(run.state().position.y() - 0.5) <= bound.tolerance);
        CHECK(run.state().velocity.x() == doctest::Approx(10).epsilon(bound.tolerance));
        CHECK(run.state().angle == doctest::Approx(-80).epsilon(bound.tolerance));
    }
}

TEST_CASE("the path of the centre over r is the angle rolled, on lines and on both sides of arcs") {
    for (Bound const& bound : bounds_of(law::path_of_centre)) {
        Run run(bound.method, scene_of({arc({0, 2}, 2, -pi, pi, material(full_grip))}, {rolling({0, 0.5}, 1.5)}));
        double path = 0;
        Vec2 last = run.state().position;
        for (int i = 1; i <= 120; ++i) {
            run.to(i / 240.0);
            Vec2 const now = run.state().position;
            double const chord = geometry::length(now - last);
            path += 2 * 1.5 * std::asin(chord / (2 * 1.5));
            last = now;
        }
        CHECK(-run.state().angle == doctest::Approx(path / 0.5).epsilon(bound.tolerance));
    }
}
