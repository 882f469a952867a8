// Handing balls that lean over to the stepping method and taking them back: nothing is remembered from one time to the
// next.
#include <cmath>
#include <utility>

#include <doctest/doctest.h>

#include "scenes/scenes.h"
#include "physics/steps/stepping.h"

using namespace physics;
using namespace scenes;

TEST_CASE("a ball that fell asleep in one hand-over is awake in the next, and falls where the floor ends") {
    std::vector<Ball> balls{disc_at({14, 40.5}), disc_at({2, 40.3}), disc_at({3.2, 40.5})};
    for (Ball& ball : balls) ball.restitution = 0;
    Run run = exact_run(chain({{0.5, 60}, {0.5, 39.6}, {4.5, 40}, {20, 40}}, material(0.9, 0, 0.02)), balls);
    run.scene.drag = {2, 1};
    run.to(3);
    // The third ball, pulled along the floor, knocks the first, which lay asleep, on its way to the edge; then it is
    // thrown against the second, and balls are handed over again.
    for (auto const& [time, target] :
         {std::pair{3.6, Vec2(9, 42)}, {3.85, Vec2(14.5, 40.6)}, {4.2, Vec2(6, 41)}, {4.9, Vec2(1.9, 40.3)}}) {
        run.pull(2, target);
        run.to(time);
    }
    run.release();
    REQUIRE(run.count(EventKind::handover) >= 2);
    double const edge = 20.5;  // m, where its centre is when it cannot touch the floor any more
    bool has_left = false;
    for (double time = 5; time < 9; time += 0.25) {
        run.to(time);
        double const before = run.state(0).velocity.y(), start = run.state(0).position.x();
        double const from = run.world.time;
        run.to(from + 0.1);
        if (start < edge) continue;
        has_left = true;
        CHECK(std::abs(run.state(0).velocity.y() - before + 9.81 * (run.world.time - from)) <= 1e-9);
    }
    CHECK(has_left);
}

TEST_CASE("each island that comes to lean is handed over by a row of its own, whenever one asks") {
    // In two shafts a ball lies on another's shoulder; those of the second fall from higher.
    auto const shaft = [](double x) { return chain({{x, 60}, {x, 0}, {x + 1.6, 0}, {x + 1.6, 60}}); };
    std::vector<Piece> pieces = shaft(0);
    for (Piece const& piece : shaft(10)) pieces.push_back(piece);
    std::vector<Ball> balls{disc_at({0.5, 0.5}), disc_at({1.1, 1.6}), disc_at({10.5, 20}), disc_at({11.1, 25})};
    for (Ball& ball : balls) ball.restitution = 0;
    std::vector<Event> rows;
    for (double const step : {20.0, 0.0137}) {
        Run run = exact_run(pieces, balls);
        for (double time = 0; time < 8; time += step) run.to(std::min(8.0, time + step));
        std::vector<std::vector<int>> told;
        rows.clear();
        for (Event const& event : run.history.events)
            if (event.kind == EventKind::handover || event.kind == EventKind::takeover) {
                rows.push_back(event);
                told.push_back(run.history.islands[static_cast<std::size_t>(event.other)]);
            }
        REQUIRE(told.size() == 2);
        CHECK(told[0] == std::vector<int>{0, 1});
        CHECK(told[1] == std::vector<int>{2, 3});
        CHECK(rows[1].time > std::sqrt(2 * 19.5 / 9.81));  // the lower one has come down
    }
}

TEST_CASE("steps begin with nothing in memory") {
    World world;
    world.time = 3;
    world.step_origin = 1;
    world.steps_taken = 7;
    world.cached_contacts.resize(2);
    world.ball_pairs.resize(2);
    world.fat_boxes.resize(2);
    world.still_steps = {9, 9};
    begin_stepping(world);
    CHECK(world.step_origin == 3);
    CHECK(world.steps_taken == 0);
    CHECK((world.cached_contacts.empty() && world.ball_pairs.empty()));
    CHECK((world.fat_boxes.empty() && world.still_steps.empty()));
}
