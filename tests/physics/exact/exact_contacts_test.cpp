// Contacts under the exact method: grips, grooves, wedges, hits, and random scenes that must keep to the laws.
#include <algorithm>
#include <cmath>
#include <random>

#include "scenes/scenes.h"

using namespace physics;
using namespace scenes;

TEST_CASE("a ball that slips where it touches full grip rolls at once, v' = (v + k s)/(1 + k)") {
    Run start = exact_run({line({0, 0}, {40, 0}, {full_grip, 0, 0})}, {disc_at({5, 0.5}, {3, 0})});
    start.to(1);
    CHECK(start.state().position.x() == doctest::Approx(7).epsilon(1e-14));
    CHECK(start.state().spin == doctest::Approx(-4).epsilon(1e-14));
    // From ice on to full grip: spin 5 is a rim speed of -2.5, so 3 m/s become (3 - 1.25)/1.5.
    Run joint = exact_run({line({0, 0}, {10, 0}, {0, 0, 0}), line({10, 0}, {40, 0}, {full_grip, 0, 0})},
                          {disc_at({5, 0.5}, {3, 0}, 5)});
    joint.to(3);
    CHECK(joint.state().velocity.x() == doctest::Approx(1.75 / 1.5).epsilon(1e-13));
}

TEST_CASE("a ball that falls into the middle of a groove stays there") {
    Run run = exact_run({line({-5, 5}, {0, 0}), line({0, 0}, {5, 5})}, {disc_at({0, 4})});
    run.to(3);
    CHECK(run.state().position.x() == 0);
    CHECK(run.state().position.y() == doctest::Approx(0.5 * std::sqrt(2.0)).epsilon(1e-12));
    CHECK(run.leg().phase == Phase::rest);
}

TEST_CASE("a ball pulled into the wedge of a floor and an arc stops there") {
    Run run = exact_run({line({0, 0}, {10, 0}), arc({12, 0}, 2, pi, -pi)}, {disc_at({5, 0.5})});
    run.scene.drag = {10, 2};
    run.to(0.5);
    run.pull(0, {14, -2});
    for (int i = 1; i <= 200; ++i) {
        run.to(0.5 + 0.02 * i);
        REQUIRE(clearance(run) >= -1e-9);
    }
    // The centre is 0.5 above the floor and 2.5 from the arc's centre.
    CHECK(run.state().position.x() == doctest::Approx(12 - std::sqrt(6.0)).epsilon(1e-9));
}

TEST_CASE("a ball that flies along a line goes on along the arc that the line is tangent to") {
    // No gravity: nothing presses it on the line; the arc then turns it by a half turn and keeps its speed.
    Run run = exact_run({line({0, 0}, {5, 0}, {0, 0, 0}), arc({5, 2}, 2, -pi / 2, pi, material(0))},
                        {disc_at({1, 0.5}, {2, 0})}, 0);
    double const turned = 2 + pi * 1.5 / 2;  // s, at which it leaves the arc
    run.to(turned + 1);
    CHECK(run.state().position.x() == doctest::Approx(5 - 2).epsilon(1e-9));
    CHECK(run.state().position.y() == doctest::Approx(3.5).epsilon(1e-9));
    CHECK(run.state().velocity.x() == doctest::Approx(-2).epsilon(1e-12));
}

TEST_CASE("a swing on the spring is one leg for ever unless something lies within its reach") {
    for (double const wall : {3.5 + 1e-6, 3.5 - 1e-6}) {  // the disc's rim swings from 0.5 to 3.5 m and back
        Run run = exact_run({line({wall, -9}, {wall, 9})}, {disc_at({1, 0})}, 0);
        run.scene.drag = {2, 0};
        run.pull(0, {2, 0});
        run.to(0.1);
        CHECK((run.leg().until == never) == (wall > 3.5));
        run.to(10);
        CHECK((run.count(EventKind::land) == 0) == (wall > 3.5));
    }
}

TEST_CASE("a hit throws a rolling ball off the floor and sets the other slipping, and says so") {
    Run run = exact_run({line({0, 0}, {40, 0})}, {disc_at({5, 0.5}, {3, 0}, -6), disc_at({10, 0.5})});
    run.to(1.4);
    CHECK(run.count(EventKind::hit) == 1);
    CHECK(run.count(EventKind::lift) == 1);
    CHECK(run.count(EventKind::slip) == 1);
    CHECK(run.count(EventKind::land) == 0);
}

TEST_CASE("a ball dropped on a resting one needs a handful of events, not a watchdog's worth") {
    Run run = exact_run({line({0, 0}, {10, 0})}, {disc_at({5, 0.5}), disc_at({5, 4})});
    run.to(3);
    CHECK(run.history.events.size() < 150);
    CHECK(run.state(1).position.y() > 1.4);
}

TEST_CASE("in random scenes nothing sinks in, gets out, gains energy or is lost") {
    for (int seed = 0; seed < 60; ++seed) {
        CAPTURE(seed);
        std::mt19937 random(static_cast<unsigned>(seed));
        // Not std::uniform_real_distribution, whose numbers differ between libraries.
        auto const between = [&](double low, double high) { return low + (high - low) * (random() / 4294967296.0); };
        auto const any_material = [&] {
            double const frictions[] = {0, full_grip, between(0.05, 1.5), between(0.05, 1.5)};
            double const restitutions[] = {0, 0, between(0, 0.95), 1};
            return Material{frictions[random() % 4], restitutions[random() % 4],
                            random() % 3 == 0 ? between(0, 0.2) : 0};
        };
        std::vector<Piece> pieces = ring({{0, 0}, {10, 0}, {10, 8}, {0, 8}});
        for (Piece& piece : pieces) piece.material = any_material();
        for (unsigned i = 0; i < 1 + random() % 5; ++i) {
            Vec2 const at(between(1, 9), between(0.5, 6));
            if (random() % 2 == 0)
                pieces.push_back(arc(at, between(0.6, 2), between(-3, 3), between(-3, 3), any_material()));
            else
                pieces.push_back(line(at, {between(1, 9), between(0.5, 6)}, any_material()));
        }
        Ball ball = disc(between(0.1, 0.3), Vec2::Zero(), {between(-5, 5), between(-5, 5)}, between(-10, 10));
        do ball.start.position = {between(0.5, 9.5), between(0.5, 7.5)};
        while (std::any_of(pieces.begin(), pieces.end(), [&](Piece const& p) {
            return nearest_point(p.curve, ball.start.position).distance < ball.radius + 1e-3;
        }));
        Run run = exact_run(pieces, {ball});
        double energy = energy_of(run);
        for (int i = 1; i <= 200; ++i) {
            run.to(i / 20.0);
            Vec2 const p = run.state().position;
            REQUIRE(geometry::is_finite(p));
            REQUIRE(clearance(run) >= -1e-9);
            REQUIRE((p.x() > 0 && p.x() < 10 && p.y() > 0 && p.y() < 8));
            REQUIRE(energy_of(run) <= energy + 1e-11 * (1 + energy));
            energy = std::min(energy, energy_of(run));
        }
    }
}
