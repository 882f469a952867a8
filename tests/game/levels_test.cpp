// The levels that ship: no robot wins them, their springs are weaker than a ball's weight, and for each there is a run
// that wins gold and ends as it claims.
#include <algorithm>
#include <filesystem>
#include <initializer_list>

#include <doctest/doctest.h>

#include "game/medals.h"
#include "robots.h"
#include "scenes/levels.h"

namespace {

namespace files = std::filesystem;

std::vector<files::path> shipped_levels() {
    std::vector<files::path> levels;
    for (auto const& entry : files::directory_iterator(ASSETS "/levels"))
        if (entry.path().extension() == ".svg") levels.push_back(entry.path());
    std::sort(levels.begin(), levels.end());
    return levels;
}

std::shared_ptr<level::Level const> read(files::path const& file) { return scenes::read_level(file.string()); }

game::Session game_of(std::shared_ptr<level::Level const> const& level) {
    return game::session_of(level, game::method_for({}, level->scene));
}

constexpr double robots_patience = 60;           // s
constexpr double changing_robots_patience = 20;  // s

}  // namespace

TEST_CASE("no robot wins a level but the first two") {
    auto const levels = shipped_levels();
    REQUIRE(levels.size() > 2);
    for (std::size_t i = 2; i < levels.size(); ++i) {
        auto const level = read(levels[i]);
        for (game_test::Robot const& robot : game_test::robots()) {
            CAPTURE(levels[i].filename().string());
            CAPTURE(robot.name);
            game::Session session = game_of(level);
            robot.play(session, std::min(robots_patience, level->time_limit.value_or(robots_patience)));
            CHECK(session.goal_time.value_or(-1) == -1);
        }
    }
}

// The named levels are about one change of mind at the right time: a swing, a brake.
TEST_CASE("no robot that changes its mind once wins a level but the first two and those about that") {
    auto const levels = shipped_levels();
    REQUIRE(levels.size() > 2);
    auto const is_one_of = [](files::path const& file, std::initializer_list<char const*> numbers) {
        return std::count(numbers.begin(), numbers.end(), file.filename().string().substr(0, 2)) > 0;
    };
    for (std::size_t i = 2; i < levels.size(); ++i) {
        auto const level = read(levels[i]);
        std::vector<game_test::TwoStepRobot> robots;
        if (level->tilt_limit > 0 && !is_one_of(levels[i], {"03", "08", "09"})) robots = game_test::tilting_robots();
        if (level->drag_reach > 0 && !is_one_of(levels[i], {"05"}))
            for (game_test::TwoStepRobot const& robot : game_test::pulling_robots()) robots.push_back(robot);
        for (game_test::TwoStepRobot const& robot : robots)
            for (double change = 0.5; change <= 6; change += 0.5) {
                CAPTURE(levels[i].filename().string());
                CAPTURE(robot.name);
                CAPTURE(change);
                game::Session session = game_of(level);
                robot.first(session, change);
                robot.then(session, changing_robots_patience);
                CHECK(session.goal_time.value_or(-1) == -1);
            }
    }
}

TEST_CASE("no spring of a shipped level lifts a ball") {
    constexpr double pi = 3.14159265358979;
    for (files::path const& file : shipped_levels()) {
        CAPTURE(file.filename().string());
        auto const level = read(file);
        double const stiffness = std::pow(2 * pi * level->scene.drag.frequency, 2);  // 1/s^2
        CHECK(stiffness * level->drag_reach < level->scene.gravity);
        CHECK((level->drag_reach > 0 || level->tilt_limit > 0));
    }
}

TEST_CASE("every shipped level asks for a time and says what to do") {
    for (files::path const& file : shipped_levels()) {
        CAPTURE(file.filename().string());
        auto const level = read(file);
        CHECK(level->pars.time);
        CHECK((level->drag_reach == 0 || level->pars.pulls));
        CHECK(!level->hint.empty());
        CHECK(game::bananas_in(*level) > 0);
    }
}

TEST_CASE("the hole of Snowballs holds a snowball, and the player's ball is lost in it") {
    auto level = level::read_level(ASSETS "/levels/18-snowballs.svg");
    std::size_t const player = static_cast<std::size_t>(level.player), snowball = player + 1;
    double const slot = 11.835;  // m, the middle of the leftmost gap between the bars, whose tops are at 1.575 m
    auto const dropped = [&](std::size_t ball) {
        level::Level changed = level;
        changed.scene.balls[ball].start.position = {slot, 3};
        auto session = game_of(std::make_shared<level::Level const>(changed));
        game::advance(session, 10);
        return session;
    };
    CHECK(dropped(player).fall_time);
    game::Session const session = dropped(snowball);
    CHECK(physics::state_at(session.history, static_cast<int>(snowball), 10).position.y() ==
          doctest::Approx(1.7).epsilon(0.05));
}

TEST_CASE("every shipped level has a run of its name that wins gold and ends as it claims") {
    for (files::path const& file : shipped_levels()) {
        CAPTURE(file.filename().string());
        game::Run const run = game::read_run(ASSETS "/runs/" + file.stem().string() + ".json");
        game::Session session = scenes::session_of_run(run);
        CHECK(files::equivalent(run.level_file, file));
        CHECK(run.level_hash == session.level->hash);
        REQUIRE(run.final);
        game::advance(session, run.final->time);
        CHECK(run.final->state_hash == game::state_hash(session, run.final->time));
        REQUIRE(session.goal_time);
        CHECK(game::medal_for(*session.level, game::status_at(session, *session.goal_time)) == game::Medal::gold);
    }
}
