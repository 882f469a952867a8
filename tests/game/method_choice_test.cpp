#include <doctest/doctest.h>

#include <cmath>

#include "game/method_choice.h"
#include "geometry/elementary.h"
#include "physics/world/overlap.h"

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
    CHECK(game::rate_within(2.5e-5, with_balls(1)) == doctest::Approx(240).epsilon(1e-12));
    CHECK(game::rate_within(2.5e-7, with_balls(1)) == doctest::Approx(2400).epsilon(1e-12));
    CHECK(game::rate_within(1, with_balls(1)) == 240);
    CHECK(game::rate_within(1e-300, with_balls(1)) == 1e5);
}

TEST_CASE("a pile's rate grows with the root of what a column of its mean height weighs, between 60 and 960 a second") {
    // sqrt(25 * 8 g / (pi rate)^2 = tolerance), 128 balls being 8 on each other.
    physics::Scene pile = with_balls(128);
    double const at_240 = 25 * 8 * pile.gravity / std::pow(geometry::pi * 240, 2);
    CHECK(game::rate_within(at_240, pile) == doctest::Approx(240).epsilon(1e-12));
    CHECK(game::rate_within(at_240 / 4, pile) == doctest::Approx(480).epsilon(1e-12));
    CHECK(game::rate_within(1, pile) == 60);
    CHECK(game::rate_within(1e-9, pile) == 960);
    pile.balls[5].mass = 4;
    CHECK(game::rate_within(at_240, pile) == doctest::Approx(480).epsilon(1e-12));
    pile.gravity *= 0.25;
    CHECK(game::rate_within(at_240, pile) == doctest::Approx(240).epsilon(1e-12));
}

TEST_CASE("what is chosen for a pile is said with what it kept, or that nothing is known to keep that") {
    physics::Scene const pile = with_balls(128);
    double const at_240 = 25 * 8 * pile.gravity / std::pow(geometry::pi * 240, 2);
    CHECK(game::choice_for(within(at_240 * (1 + 1e-12)), pile)
              .why.rfind("steps at 240 steps/s kept 0.0035 m in every pile that was measured; ", 0) == 0);
    CHECK(game::choice_for(within(1e-6), pile)
              .why.rfind("nothing is known to keep 1e-06 m; nearest, steps at 960 steps/s; ", 0) == 0);
}

TEST_CASE("a named rate weighs more than a tolerance, and nothing is said of another") {
    game::MethodWish wish = within(1e-3);
    wish.rate = 77;
    physics::Choice const choice = game::choice_for(wish, with_balls(30));
    CHECK(game::rate_of(choice.method) == 77);
    CHECK(choice.why.find("steps/s") == std::string::npos);
}

TEST_CASE("a pile that settles at the rate chosen for a tolerance overlaps by no more") {
    for (int const count : {12, 60}) {
        physics::Scene scene;
        int const columns = static_cast<int>(std::sqrt(2 * count));
        double const width = 1.05 * columns + 1;
        for (int i = 0; i < count; ++i) {
            physics::Ball& ball = scene.balls.emplace_back();
            ball.radius = 0.5;
            ball.start.position = {1 + 1.05 * (i % columns) + 0.02 * (i / columns % 3), 0.6 + 1.02 * (i / columns)};
        }
        auto const wall = [](physics::Vec2 const& from, physics::Vec2 const& to) {
            return physics::Piece{geometry::Segment{from, to}, {}, 0};
        };
        scene.terrain =
            physics::terrain_of({wall({0, 0}, {width, 0}), wall({0, 0}, {0, 50}), wall({width, 0}, {width, 50})});
        for (double const tolerance : {1e-2, 1e-3}) {
            CAPTURE(count);
            physics::Method const method = game::method_for(within(tolerance), scene);
            physics::History history;
            physics::World world = physics::world_at_start(method, scene, history);
            double deepest = 0;
            for (int frame = 1; frame <= 120; ++frame) {
                physics::advance(method, scene, world, frame / 60.0, history);
                std::vector<physics::Vec2> centres;
                for (int ball = 0; ball < count; ++ball)
                    centres.push_back(physics::state_at(history, ball, world.time).position);
                deepest = std::max(deepest, physics::deepest_overlap(scene, centres));
                physics::forget_before(history, world.time);
            }
            CHECK(deepest > 0);
            CHECK(deepest <= tolerance);
        }
    }
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

TEST_CASE("steps keeps a tolerance for a ball alone, also between its steps") {
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
