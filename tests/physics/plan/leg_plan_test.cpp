// Two ways to the same motion on an arc, in closed form and by power series, must tell the same.
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <doctest/doctest.h>

#include "geometry/elementary.h"
#include "physics/plan/plan_track.h"

using namespace physics;
using geometry::pi;

namespace {

// A ball that rolls on an arc, from anywhere on it, with any field and grip.
struct Case {
    Terrain terrain;
    Ball ball;
    Field field;
    SurfaceState on_track;

    MotionContext context() const { return {terrain, ball, field}; }
};

Case case_of(unsigned seed) {
    std::mt19937 random(seed);
    auto const between = [&](double low, double high) { return low + (high - low) * (random() / 4294967296.0); };
    Case c;
    double const frictions[] = {std::numeric_limits<double>::infinity(), between(0.05, 1.5)};
    double const sweep = random() % 4 == 0 ? 2 * pi : between(0.5, 5);
    c.terrain = terrain_of(
        {{geometry::Arc{
              {between(-2, 2), between(-2, 2)}, between(0.7, 5), between(-pi, pi), random() % 2 == 0 ? sweep : -sweep},
          {frictions[random() % 2], 0, 0},
          0}});
    c.ball.radius = between(0.1, 0.6);
    c.ball.inertia = between(0, 1);
    c.field.gravity = between(0, 20) * Vec2(between(-1, 1), between(-1, 1));
    if (random() % 3 == 0) {
        c.field.pulled = true;
        c.field.target = {between(-5, 5), between(-5, 5)};
        c.field.spring = {0, between(0.1, 30)};
    }
    c.on_track.contact = {0, random() % 2 == 0 ? 1 : -1};
    c.on_track.track = track_of(c.terrain, c.on_track.contact, c.ball.radius);
    c.on_track.q = between(0, 1) * c.on_track.track.length;
    double const speeds[] = {0, between(-3, 3), between(-12, 12)};
    c.on_track.speed = c.on_track.rim = speeds[random() % 3];
    c.on_track.angle = between(-9, 9);
    return c;
}

}  // namespace

TEST_CASE("rolling on an arc ends at the same event in closed form and by power series, and goes the same way there") {
    int ends = 0, goes_on = 0;
    for (unsigned seed = 0; seed < 20000; ++seed) {
        CAPTURE(seed);
        Case const c = case_of(seed);
        MotionContext const context = c.context();
        if (!is_pressed(context, c.on_track)) continue;
        ContactMode const mode = contact_mode_for(context, c.on_track, ModeHint::none);
        TrackEnds const track_ends =
            ends_of_track(c.terrain, c.on_track.contact, c.on_track.track, c.on_track.q, c.ball.radius);
        auto const closed = plan_pendulum(context, c.on_track, mode, track_ends, 0);
        if (!closed) continue;
        LegPlan const series = plan_circle(context, c.on_track, mode, track_ends, 0);
        if (series.end.cause == LegEndCause::goes_on) {
            REQUIRE(closed->end.time >= series.end.time);
            ++goes_on;
        } else {
            REQUIRE(closed->end.cause == series.end.cause);
            // Events are where they are to rounding; a slow ball's time of them is worth less.
            State const there = at(series.leg, series.end.time);
            double const slack = 1e-12 * (1 + 1 / (geometry::length(there.velocity) + 1e-3));
            REQUIRE(std::abs(closed->end.time - series.end.time) <= slack);
            REQUIRE(closed->end.next == series.end.next);
            ++ends;
        }
        for (double const share : {0.0, 0.3, 0.7, 1.0}) {
            State const a = at(closed->leg, share * series.end.time), b = at(series.leg, share * series.end.time);
            // Rounding of the place, and what the sensitivity of a pendulum near its top makes of it.
            double const tolerance = 2e-13 * (1 + geometry::length(b.velocity));
            REQUIRE(geometry::length(a.position - b.position) <= tolerance);
            REQUIRE(geometry::length(a.velocity - b.velocity) <= 10 * tolerance);
            REQUIRE(std::abs(a.angle - b.angle) <= 10 * tolerance);
            REQUIRE(std::abs(a.spin - b.spin) <= 100 * tolerance);
        }
    }
    CHECK(ends >= 500);
    CHECK(goes_on >= 500);
}
