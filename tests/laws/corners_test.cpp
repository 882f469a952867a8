// T9 and T3: walls, steps, vertices, and polylines that stand for curves.
#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

#include "bounds.h"

using namespace laws;
using geometry::length;

namespace {

physics::Scene towards_a_wall() {
    return scene_of(chain({{-9, 0}, {0, 0}, {0, 9}}, material(full_grip)), {rolling({-1.5, 0.5}, 2)});
}

// A hill of radius 5 about (0, -5) as a polyline of `count` chords from 0.3 rad left of the top to 0.3 rad right of it.
std::vector<physics::Piece> polyline_hill(int count) {
    auto const corner = [&](int i) {
        double const angle = -0.3 + 0.6 * i / count;
        return Vec2(5 * std::sin(angle), 5 * std::cos(angle) - 5);
    };
    std::vector<Vec2> corners;
    for (int i = 0; i <= count; ++i) corners.push_back(corner(i));
    return chain(corners, material(full_grip));
}

// A disc on the middle of the first chord, rolling up it.
physics::Scene on_polyline_hill(int count, double speed) {
    std::vector<physics::Piece> const pieces = polyline_hill(count);
    auto const& first = std::get<geometry::Segment>(pieces[0].curve);
    Vec2 const along = (first.end - first.start) / length(first.end - first.start);
    Vec2 const middle = 0.5 * (first.start + first.end);
    return scene_of(pieces, {disc_at(middle + 0.5 * geometry::turned_left(along), speed * along, -speed / 0.5)});
}

}  // namespace

TEST_CASE("T9: a disc rolling into a wall climbs it at v / 3") {
    for (Bound const& bound : bounds_of(law::corner)) {
        Run run(bound.method, towards_a_wall());
        run.to(0.55);
        double const since = run.world.time - 0.5;
        CHECK(run.state().velocity.y() == doctest::Approx(2.0 / 3 - g * since).epsilon(bound.tolerance));
    }
}

TEST_CASE("T9 pinned: article: at a wall the ball stops dead") {
    physics::State const state = state_after(physics::Article{}, towards_a_wall(), 1);
    CHECK(length(state.velocity) <= 1e-9);
    CHECK(state.position.x() == doctest::Approx(-0.5));
}

TEST_CASE("T9: a disc climbs a step from the speed of physics.md 5.4 on, and not below") {
    double const least = 1.31963;  // m/s, physics.md 5.4: r = 0.5, h = 0.1
    for (Bound const& bound : bounds_of(law::corner))
        for (double const share : {0.995, 1.005}) {
            physics::Scene const scene = scene_of(chain({{-9, 0}, {0, 0}, {0, 0.1}, {9, 0.1}}, material(full_grip)),
                                                  {rolling({-1.5, 0.5}, share * least)});
            CHECK((state_after(bound.method, scene, 6).position.x() > 0) == (share > 1));
        }
}

TEST_CASE("T3: at a convex vertex a disc pivots below v^2 = g r, 2.215 m/s, and is thrown above") {
    CHECK(std::sqrt(g * 0.5) == doctest::Approx(2.215).epsilon(1e-4));
    for (Bound const& bound : bounds_of(law::vertex))
        for (double const share : {1 - bound.tolerance, 1 + bound.tolerance}) {
            double const speed = share * std::sqrt(g * 0.5);
            Run run(bound.method,
                    scene_of(chain({{-5, 0}, {0, 0}, {0, -5}}, material(full_grip)), {rolling({-1, 0.5}, speed)}));
            run.to(1.1 / speed);
            double const corner = run.time_of(physics::EventKind::corner);
            double const lift = run.time_of(physics::EventKind::lift);
            CHECK(corner == doctest::Approx(1 / speed).epsilon(1e-9));
            // Just below it holds on until cos has fallen by twice the share: some 9 ms for a share of 1e-3, and less
            // as its root.
            CHECK((lift - corner > 4e-3 * std::sqrt(bound.tolerance / 1e-3)) == (share < 1));
        }
}

TEST_CASE("T3: a polyline is no substitute for a hill: at 4 m/s it throws the disc at once, however fine it is") {
    for (Bound const& bound : bounds_of(law::hill)) {
        if (std::holds_alternative<physics::Article>(bound.method)) continue;  // it tells of no lift
        for (int const chords : {8, 32, 128}) {
            CAPTURE(std::string(physics::name_of(bound.method)));
            CAPTURE(chords);
            // Hops take most of the way: it is in the air at most of the times.
            Run fast(bound.method, on_polyline_hill(chords, 4)), slow(bound.method, on_polyline_hill(chords, 2.1));
            int in_air = 0;
            for (int i = 1; i <= 120; ++i) {
                fast.to(i / 240.0);
                in_air += fast.leg().phase == physics::Phase::flight;
            }
            CHECK(fast.count(physics::EventKind::lift) >= chords / 4);
            CHECK(in_air > 30);
            slow.to(0.5);
            CHECK(slow.count(physics::EventKind::lift) == 0);
        }
    }
}

TEST_CASE("T3: the hop over a vertex is as long as the parabola says") {
    // Off a flat line at v, on to one that falls by an angle d: the centre's parabola meets the second line's parallel
    // where g x^2 / (2 v^2) - x tan d + r (1 / cos d - 1) = 0.
    double const v = 4, d = 0.05, r = 0.5;
    double const half = std::tan(d) * v * v / g;
    double const x = half + std::sqrt(half * half - 2 * v * v / g * r * (1 / std::cos(d) - 1));
    for (Bound const& bound : bounds_of(law::corner)) {
        CAPTURE(std::string(physics::name_of(bound.method)));
        Run run(bound.method,
                scene_of(chain({{-5, 0}, {0, 0}, {5 * std::cos(d), -5 * std::sin(d)}}, material(full_grip)),
                         {rolling({-1, 0.5}, v)}));
        run.to(1);
        double const lift = run.time_of(physics::EventKind::lift), land = run.time_of(physics::EventKind::land);
        CHECK(lift == doctest::Approx(1 / v).epsilon(bound.tolerance));
        CHECK(land - lift == doctest::Approx(x / v).epsilon(100 * bound.tolerance));
    }
}
