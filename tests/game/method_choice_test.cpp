#include <doctest/doctest.h>

#include <cmath>

#include "game/method_choice.h"

namespace {

game::MethodWish within(double tolerance, std::optional<std::string> name = std::nullopt) {
    game::MethodWish wish;
    wish.name = std::move(name);
    wish.tolerance = tolerance;
    return wish;
}

physics::Scene with_balls(std::size_t count) {
    physics::Scene scene;
    scene.balls.resize(count);
    return scene;
}

}  // namespace

TEST_CASE("a hundredth of the error takes ten times the rate, between the usual and 1e5 steps a second") {
    CHECK(game::rate_within(2.5e-5) == doctest::Approx(240).epsilon(1e-12));
    CHECK(game::rate_within(2.5e-7) == doctest::Approx(2400).epsilon(1e-12));
    CHECK(game::rate_within(1) == 240);
    CHECK(game::rate_within(1e-300) == 1e5);
}

TEST_CASE("exact keeps any tolerance; where steps is chosen or named its rate is raised") {
    CHECK(std::holds_alternative<physics::Exact>(game::method_for(within(1e-9), with_balls(1))));
    CHECK(std::holds_alternative<physics::Steps>(game::method_for(within(2.5e-7), with_balls(30))));
    CHECK(game::rate_of(game::method_for(within(2.5e-7, "steps"), with_balls(1))) ==
          doctest::Approx(2400).epsilon(1e-12));
    game::MethodWish named = within(2.5e-7, "steps");
    named.rate = 100;
    CHECK(game::rate_of(game::method_for(named, with_balls(1))) == 100);
}

TEST_CASE("a tolerance that cannot be meant is objected to, and any with the article's rule") {
    for (double const tolerance : {0.0, -1.0, double{INFINITY}, std::nan("")})
        CHECK(game::objection_to(within(tolerance)));
    CHECK(game::objection_to(within(1, "article")));
    CHECK_FALSE(game::objection_to(within(1)));
}

TEST_CASE("steps keeps a tolerance in a smooth motion, also between its steps") {
    // A ball that was at rest in the air: g t^2 / 2.
    physics::Scene const scene = with_balls(1);
    for (double const tolerance : {1e-5, 1e-6, 1e-7}) {
        physics::Method const method = game::method_for(within(tolerance, "steps"), scene);
        physics::History history;
        physics::World world = physics::world_at_start(method, scene, history);
        physics::advance(method, scene, world, 1, history);
        for (double const t : {0.1, 1.0 / 3, 0.7777, 0.99999})
            CHECK(std::abs(physics::state_at(history, 0, t).position.y() + scene.gravity * t * t / 2) <= tolerance);
    }
}
