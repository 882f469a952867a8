// Contacts under the exact method: grips, grooves, wedges, hits, and random scenes that must keep to the laws.
#include <algorithm>
#include <cmath>
#include <random>

#include "physics/exact/exact_run.h"
#include "geometry/elementary.h"

using namespace context;
using geometry::Arc;
using geometry::pi;

TEST_CASE("a ball that slips where it touches full grip rolls at once, v' = (v + k s)/(1 + k)") {
    StepContext start({line({0, 0}, {40, 0}, {full_grip, 0, 0})}, {disc(0.5, {5, 0.5}, {3, 0})});
    start.to(1);
    CHECK(start.now().position.x() == doctest::Approx(7).epsilon(1e-14));
    CHECK(start.now().spin == doctest::Approx(-4).epsilon(1e-14));
    // From ice on to full grip: spin 5 is a rim speed of -2.5, so 3 m/s become (3 - 1.25)/1.5.
    StepContext joint({line({0, 0}, {10, 0}, {0, 0, 0}), line({10, 0}, {40, 0}, {full_grip, 0, 0})},
                      {disc(0.5, {5, 0.5}, {3, 0}, 5)});
    joint.to(3);
    CHECK(joint.now().velocity.x() == doctest::Approx(1.75 / 1.5).epsilon(1e-13));
}

TEST_CASE("a ball that falls into the middle of a groove stays there") {
    StepContext context({line({-5, 5}, {0, 0}), line({0, 0}, {5, 5})}, {disc(0.5, {0, 4})});
    context.to(3);
    CHECK(context.now().position.x() == 0);
    CHECK(context.now().position.y() == doctest::Approx(0.5 * std::sqrt(2.0)).epsilon(1e-12));
    CHECK(context.world.legs[0].phase == Phase::rest);
}

TEST_CASE("a ball pulled into the wedge of a floor and an arc stops there") {
    StepContext context({line({0, 0}, {10, 0}), {Arc{{12, 0}, 2, pi, -pi}, {}, 0}}, {disc(0.5, {5, 0.5})});
    context.scene.drag = {10, 2};
    context.to(0.5);
    context.pull(Pull{0, {14, -2}});
    for (int i = 1; i <= 200; ++i) {
        context.to(0.5 + 0.02 * i);
        REQUIRE(context.clearance() >= -1e-9);
    }
    // The centre is 0.5 above the floor and 2.5 from the arc's centre.
    CHECK(context.now().position.x() == doctest::Approx(12 - std::sqrt(6.0)).epsilon(1e-9));
}

TEST_CASE("a ball that flies along a line goes on along the arc that the line is tangent to") {
    // No gravity: nothing presses it on the line; the arc then turns it by a half turn and keeps its speed.
    StepContext context({line({0, 0}, {5, 0}, {0, 0, 0}), {Arc{{5, 2}, 2, -pi / 2, pi}, {0, 0, 0}, 0}},
                        {disc(0.5, {1, 0.5}, {2, 0})}, 0);
    double const turned = 2 + pi * 1.5 / 2;  // s, at which it leaves the arc
    context.to(turned + 1);
    CHECK(context.now().position.x() == doctest::Approx(5 - 2).epsilon(1e-9));
    CHECK(context.now().position.y() == doctest::Approx(3.5).epsilon(1e-9));
    CHECK(context.now().velocity.x() == doctest::Approx(-2).epsilon(1e-12));
}

TEST_CASE("a swing on the spring is one leg for ever unless something lies within its reach") {
    for (double const wall : {3.5 + 1e-6, 3.5 - 1e-6}) {  // the disc's rim swings from 0.5 to 3.5 m and back
        StepContext context({line({wall, -9}, {wall, 9})}, {disc(0.5, {1, 0})}, 0);
        context.scene.drag = {2, 0};
        context.pull(Pull{0, {2, 0}});
        context.to(0.1);
        CHECK((context.world.legs[0].until == never) == (wall > 3.5));
        context.to(10);
        CHECK((context.count(EventKind::land) == 0) == (wall > 3.5));
    }
}

TEST_CASE("a hit throws a rolling ball off the floor and sets the other slipping, and says so") {
    StepContext context({line({0, 0}, {40, 0})}, {disc(0.5, {5, 0.5}, {3, 0}, -6), disc(0.5, {10, 0.5})});
    context.to(1.4);
    CHECK(context.count(EventKind::hit) == 1);
    CHECK(context.count(EventKind::lift) == 1);
    CHECK(context.count(EventKind::slip) == 1);
    CHECK(context.count(EventKind::land) == 0);
}

TEST_CASE("a ball dropped on a resting one needs a handful of events, not a watchdog's worth") {
    StepContext context({line({0, 0}, {10, 0})}, {disc(0.5, {5, 0.5}), disc(0.5, {5, 4})});
    context.to(3);
    CHECK(context.history.events.size() < 150);
    CHECK(context.now(1).position.y() > 1.4);
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
        Vec2 const corners[] = {{0, 0}, {10, 0}, {10, 8}, {0, 8}};
        std::vector<Piece> pieces;
        for (int i = 0; i < 4; ++i) pieces.push_back(line(corners[i], corners[(i + 1) % 4], any_material()));
        for (unsigned i = 0; i < 1 + random() % 5; ++i) {
            Vec2 const at(between(1, 9), between(0.5, 6));
            if (random() % 2 == 0)
                pieces.push_back({Arc{at, between(0.6, 2), between(-3, 3), between(-3, 3)}, any_material(), 0});
            else
                pieces.push_back(line(at, {between(1, 9), between(0.5, 6)}, any_material()));
        }
        StepContext context(pieces, {}, 9.81);
        Ball ball = disc(between(0.1, 0.3), Vec2::Zero(), {between(-5, 5), between(-5, 5)}, between(-10, 10));
        do ball.start.position = {between(0.5, 9.5), between(0.5, 7.5)};
        while (std::any_of(pieces.begin(), pieces.end(), [&](Piece const& p) {
            return nearest_point(p.curve, ball.start.position).distance < ball.radius + 1e-3;
        }));
        context.scene.balls = {ball};
        context.world = world_at_start(Exact{}, context.scene, context.history);
        double energy = context.energy();
        for (int i = 1; i <= 200; ++i) {
            context.to(i / 20.0);
            Vec2 const p = context.now().position;
            REQUIRE(geometry::is_finite(p));
            REQUIRE(context.clearance() >= -1e-9);
            REQUIRE((p.x() > 0 && p.x() < 10 && p.y() > 0 && p.y() < 8));
            REQUIRE(context.energy() <= energy + 1e-11 * (1 + energy));
            energy = std::min(energy, context.energy());
        }
    }
}
