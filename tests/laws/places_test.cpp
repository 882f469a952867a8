// T15: far from the origin everything goes as it does at the origin.
#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

#include "bounds.h"

using namespace laws;
using geometry::length;

namespace {

// How far a ball on the course at (away, -away) is at most off its path at the origin, in radii, over 5 s from two
// heights.
double off_the_path(physics::Method const& method, double away) {
    Vec2 const origin(away, -away);
    double most = 0;
    for (double const height : {4.2, 4.25}) {
        Run here(method, course_at({0, 0}, 0, height)), there(method, course_at(origin, 0, height));
        for (int i = 1; i <= 100; ++i) {
            here.to(0.05 * i);
            there.to(0.05 * i);
            most = std::max(most, length(there.state().position - origin - here.state().position));
        }
    }
    return most / 0.5;
}

// A disc that bounces with e = 1/2 under 8 m/s^2 from 1 m, so that all times, places and speeds are binary fractions.
physics::Scene binary_bounces(Vec2 const& origin) {
    return scene_of({line(origin + Vec2(-64, 0), origin + Vec2(64, 0), material(0, 0.5))},
                    {disc_at(origin + Vec2(0, 1.5), {2, 0})}, 8);
}

}  // namespace

TEST_CASE("T15: a scene 1e4 and 1e5 m from the origin takes the same path") {
    for (Bound const& bound : bounds_of(law::far_away)) {
        CAPTURE(std::string(physics::name_of(bound.method)));
        CHECK(off_the_path(bound.method, 1e4) <= bound.tolerance);
        CHECK(off_the_path(bound.method, 1e5) <= bound.tolerance);
    }
}

TEST_CASE("T15 pinned: article rounds its places each step, the coarser the further away") {
    // Doubles at 1e5 m are 1.5e-11 m apart; 1200 steps lose a few hundred times as much, where 1e-9 r is wanted.
    CHECK(off_the_path(physics::Article{}, 1e5) > 1e-9);
    CHECK(off_the_path(physics::Article{}, 1e7) > 1e-7);
    CHECK(off_the_path(physics::Article{}, 1e7) <= 1e-4);
}

TEST_CASE("T15: exact keeps its contacts at 1e7 m, where doubles are further apart than what counts as touch") {
    // 1.9e-9 m against 1e-9 m; levels end at 1e6 m. A few hundred roundings of a place are left.
    CHECK(off_the_path(physics::Exact{}, 1e7) <= 1e-6);
}

TEST_CASE("T15: where every place is a double at both origins the paths are the same to the bit") {
    // Shifts by powers of two alone do not promise it: places in between are rounded where doubles are coarser.
    for (double const away : {1024.0, 131072.0, 16777216.0}) {
        Vec2 const origin(away, -away);
        Run here(physics::Exact{}, binary_bounces({0, 0})), there(physics::Exact{}, binary_bounces(origin));
        for (int i = 1; i <= 64; ++i) {
            here.to(i / 64.0);
            there.to(i / 64.0);
            physics::State state = there.state();
            state.position -= origin;
            REQUIRE(same_bits(state, here.state()));
        }
    }
    CHECK(off_the_path(physics::Exact{}, 131072) > 0);
}
