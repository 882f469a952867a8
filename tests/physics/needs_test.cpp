// What a scene asks of a method, and the method that is chosen for it.
#include "physics/needs.h"

#include <string>
#include <tuple>

#include <doctest/doctest.h>

#include "scenes/scenes.h"

using namespace physics;
using namespace scenes;

namespace {

// The names of a scene's needs, one after the other.
std::string needs_in(Scene const& scene) {
    std::string names;
    for (Reason const& reason : needs_of(scene))
        names += (names.empty() ? "" : ", ") + std::string(name_of(reason.need));
    return names;
}

Scene in_the_air(int balls, double gravity) {
    std::vector<Ball> all;
    for (int i = 0; i < balls; ++i) all.push_back(disc_at({2.0 * i, 0}));
    return scene_of({}, all, gravity);
}

}  // namespace

TEST_CASE("a scene needs what is in it, each need once, and nothing else") {
    CHECK(needs_in(scene_of({arc({0, 0}, 4, 0, 2 * pi, material(full_grip))}, {disc_at({0, 0})})) == "arcs, drag");
    CHECK(needs_in(floor_with(disc_at({0, 1}), material(full_grip))) == "corners, drag");
    CHECK(needs_in(floor_with(disc_at({0, 1}), material(0.5, 0.5, 0.1))) ==
          "corners, bounces, slip, rolling resistance, drag");
    Scene left_alone = in_the_air(2, g);
    left_alone.drag.frequency = 0;
    CHECK(needs_in(left_alone) == "pairs");
}

TEST_CASE("exact is chosen for all but piles, which more than eight balls under gravity make") {
    for (auto const& [balls, gravity, piles] :
         {std::tuple{1, g, false}, {8, g, false}, {9, g, true}, {9, 0.0, false}}) {
        Choice const choice = choice_for(in_the_air(balls, gravity));
        CHECK(std::holds_alternative<Steps>(choice.method) == piles);
        CHECK(std::holds_alternative<Exact>(choice.method) == !piles);
        CHECK((choice.why.find("piles") != std::string::npos) == piles);
    }
}
