#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

#include "bounds.h"

using namespace laws;
using geometry::length;

namespace {

struct Swing {
    double x = 0, v = 0;
};

// The damped oscillator from (x, v) in each of its regimes by the textbook's formula, in long double.
Swing swing(double frequency, double damping, Swing const& start, double t) {
    long double const omega = frequency, zeta = damping, x = start.x, v = start.v, decay = zeta * omega;
    long double const square = (zeta * zeta - 1) * omega * omega, root = std::sqrt(std::abs(square));
    auto const sum = [&](long double cosine, long double sine) {  // of e^(-decay t) times the basis
        return Swing{static_cast<double>(x * cosine + (v + decay * x) * sine),
                     static_cast<double>(v * cosine - (decay * v + omega * omega * x) * sine)};
    };
    long double const fall = std::exp(-decay * t);
    if (square == 0) return sum(fall, fall * t);
    if (square < 0) return sum(fall * std::cos(root * t), fall * std::sin(root * t) / root);
    long double const slow = std::exp(-omega * omega / (decay + root) * t), fast = std::exp(-(decay + root) * t);
    return sum((slow + fast) / 2, (slow - fast) / (2 * root));
}

// What a swing of 1 m about 0 has come to after a number of steps of 1/60 s, and the most it ever was.
struct Sweep {
    double error = 0;   // m, of place, and of speed over omega
    double excess = 0;  // the largest amplitude beyond the first, m
};
// `slower` is by how much the floor slows it. The pull is taken up anew each step, so that nothing rests on one formula
// evaluated once.
Sweep swept(physics::Method const& method, physics::Scene scene, double omega, double damping, double slower) {
    scene.drag = {omega / (2 * pi), damping};
    omega = 2 * pi * scene.drag.frequency / slower;
    Run run(method, scene);
    Vec2 const target(0, run.state().position.y());
    Sweep sweep;
    for (int i = 1; i <= 1000; ++i) {
        run.release();
        run.pull(0, target);
        run.to(i / 60.0);
        Swing const expected = swing(omega, damping / slower, {1, 0}, run.world.time);
        double const x = run.state().position.x(), v = run.state().velocity.x();
        sweep.error = std::max({sweep.error, std::abs(x - expected.x), std::abs(v - expected.v) / omega});
        sweep.excess = std::max(sweep.excess, std::hypot(x, v / omega) - 1);
        forget_before(run.history, run.world.time);
        run.history.events.clear();
    }
    return sweep;
}

// A disc at (1, 0) that only the spring pulls, or one as far along the floor.
physics::Scene disc_in_air() { return scene_of({}, {disc_at({1, 0})}, 0); }
physics::Scene disc_on_floor() { return floor_with(disc_at({1, 0.5}), material(full_grip)); }

// Whatever the stiffness and the damping.
void check_every_swing(Law const& law, physics::Scene const& scene, double slower) {
    for (Bound const& bound : bounds_of(law))
        for (int i = 1; i <= 40; i += sanitized ? 13 : 1)
            for (int j = 0; j <= 10; ++j) {
                CAPTURE(std::string(physics::name_of(bound.method)));
                CAPTURE(i * 0.1);  // omega times 1/60 s
                CAPTURE(j * 0.2);  // share of critical damping
                Sweep const sweep = swept(bound.method, scene, i * 6.0, j * 0.2, slower);
                REQUIRE(sweep.error <= bound.tolerance);
                REQUIRE(sweep.excess <= bound.tolerance);
            }
}

}  // namespace

TEST_CASE("T4: no stiffness and no damping makes a dragged ball run away or leave its swing, in the air") {
    check_every_swing(law::drag_in_air, disc_in_air(), 1);
}

TEST_CASE("T4: nor on the floor, where it swings slower by the root of 1 + k") {
    check_every_swing(law::drag_on_ground, disc_on_floor(), std::sqrt(1.5));
}

TEST_CASE("T4 pinned: article swings on the floor as in the air, too fast by the root of 1 + k") {
    for (double const damping : {0.0, 0.7, 2.0})
        CHECK(swept(physics::Article{}, disc_on_floor(), 20, damping, 1).error <= 1e-11);
}

TEST_CASE("T5: hardly damped, a pull of 5 Hz swings for ten seconds as its formula says") {
    for (Bound const& bound : bounds_of(law::drag_in_air)) {
        CAPTURE(std::string(physics::name_of(bound.method)));
        CHECK(swept(bound.method, disc_in_air(), 2 * pi * 5, 0.05, 1).error <= bound.tolerance);
    }
}

TEST_CASE("T5: dragged in the air a ball swings as the formula says, however little the damping") {
    for (Bound const& bound : bounds_of(law::drag_in_air))
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
    for (Bound const& bound : bounds_of(law::drag_on_ground)) {
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

TEST_CASE("a spring that no longer moves a hoop against its resistance tears it loose where grip ends") {
    // k = 1, c > 0: friction acts in full, the spring on the spin alone, until k |a| = mu (1 + k) g.
    physics::Ball hoop = disc_at({0, 0.5}, {6, 0}, -12);
    hoop.inertia = 1;
    physics::Scene scene = floor_with(hoop, material(0.3, 0, 0.4));
    scene.drag = {0.2, 0};
    Run run(physics::Exact{}, scene);
    physics::Vec2 const begin = run.state().position;
    run.pull(0, begin - physics::Vec2(2, 0));
    run.to(1);
    double const slip = run.time_of(physics::EventKind::slip);
    REQUIRE(slip < physics::never);
    double const stiffness = 0.16 * pi * pi, way = 2 * 0.3 * g / stiffness - 2;
    CHECK(physics::state_at(run.history, 0, slip).position.x() - begin.x() == doctest::Approx(way).epsilon(1e-12));
}

TEST_CASE("T4: pulled into the floor, at any stiffness, a ball stays within its reach") {
    for (physics::Method const& method :
         {physics::Method(physics::Exact{}), physics::Method(physics::Steps{}), physics::Method(physics::Article{})})
        for (double const frequency : {0.01, 1.0, 10.0, 38.0, 150.0, 600.0, 1e4})
            for (double const damping : {0.0, 0.5, 1.0, 2.0}) {
                CAPTURE(std::string(physics::name_of(method)));
                CAPTURE(frequency);
                CAPTURE(damping);
                physics::Scene scene = floor_with(disc_at({0, 0.5}), material(0.9));
                scene.drag = {frequency, damping};
                Run run(method, scene);
                run.pull(0, {1, 0.4});
                for (int i = 1; i <= 100; ++i) {
                    run.to(i / 60.0);
                    REQUIRE(length(run.state().position - Vec2(1, 0.4)) <= 2.5);
                }
            }
}

TEST_CASE("a pull through a wall presses the ball on it and no further") {
    physics::Scene scene = scene_of({line({2, -5}, {2, 5}, material(0.5))}, {disc_at({0, 0})}, 0);
    scene.drag = {30, 0.2};
    Run run(physics::Steps{}, scene);
    run.pull(0, {6, 1});
    run.to(3);
    CHECK(run.state().position.x() == doctest::Approx(1.5).epsilon(1e-9));
    CHECK(length(run.state().velocity) <= 1e-3);
}
