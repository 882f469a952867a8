#include "game/session.h"

#include <cmath>

#include <doctest/doctest.h>

#include "scenes/levels.h"
#include "support/folder.h"

using game::Session;
using support::message_of;
using namespace scenes;

namespace {

// Nothing but a ball in empty space, without gravity: it flies straight on.
level::Level empty_level(Vec2 const& velocity) { return level_with({disc_at({0, 0}, velocity)}, 0); }

Session stepped(level::Level const& level, std::vector<game::Input> inputs = {}, double rate = 240) {
    return session_of(level, physics::Steps{rate, 4}, std::move(inputs));
}

std::vector<game::Input> drag() {
    return {{0.11, game::Grab{0, Vec2(1, 2)}},
            {0.333, game::Move{Vec2(-1, 0.5)}},
            {0.4, game::Tilt{0.2}},
            {0.71, game::Release{}}};
}

physics::Pull pull_after(level::Level const& level, std::vector<game::Input> const& inputs) {
    Session session = stepped(level, inputs);
    game::advance(session, inputs.back().time);
    return session.world.forces.pull.value();
}

}  // namespace

TEST_CASE("an input acts at its time on a ball that no other is near, whatever the rate of steps") {
    Session session = stepped(empty_level(Vec2::Zero()), {{0.25, game::Tilt{0.2}}}, 10);
    game::advance(session, 1);
    REQUIRE(session.history.events.size() == 1);
    CHECK(session.history.events[0].time == 0.25);
}

TEST_CASE("under a method of steps alone an input acts at the first that starts at or after it") {
    Session session =
        session_of(empty_level(Vec2::Zero()), physics::Euler{10}, {{0.2, game::Tilt{0.1}}, {0.25, game::Tilt{0.2}}});
    game::advance(session, 1);
    REQUIRE(session.history.events.size() == 2);
    CHECK(session.history.events[0].kind == physics::EventKind::tilt);
    CHECK(session.history.events[0].time == 2.0 / 10);
    CHECK(session.history.events[1].time == 3.0 / 10);
    CHECK(game::forces_at(session, 0.19).tilt == 0);
    CHECK(game::forces_at(session, 0.2).tilt == 0.1);
    CHECK(game::forces_at(session, 0.29).tilt == 0.1);
    CHECK(game::forces_at(session, 0.31).tilt == 0.2);
}

TEST_CASE("how often one looks does not change what happens") {
    level::Level const level = empty_level(Vec2(1, 0));
    Session once = stepped(level, drag()), often = stepped(level, drag());
    game::advance(once, 1.3);
    for (int i = 0; i <= 1300; ++i) {
        game::advance(often, i / 1000.0);
        game::forget_before(often, i / 1000.0);
    }
    CHECK(game::state_hash(once, 1.3) == game::state_hash(often, 1.3));
}

TEST_CASE("the target of a drag is the pointer, drawn in to the reach from the ball's centre") {
    level::Level level = empty_level(Vec2::Zero());
    level.drag_reach = 5;
    CHECK(pull_after(level, {{0, game::Grab{0, Vec2(3, -2)}}}).target == Vec2(3, -2));
    Vec2 const target = pull_after(level, {{0, game::Grab{0, Vec2(30, 40)}}}).target;
    CHECK(geometry::length(target - Vec2(3, 4)) <= 1e-14);
}

TEST_CASE("a move draws the target in again, from where the ball is then") {
    level::Level level = empty_level(Vec2(2, 0));
    level.drag_reach = 1;
    level.scene.drag.frequency = 0;  // the spring does not pull, so the ball flies on
    Vec2 const target = pull_after(level, {{0, game::Grab{0, Vec2(100, 0)}}, {1, game::Move{Vec2(100, 0)}}}).target;
    CHECK(geometry::length(target - Vec2(3, 0)) <= 1e-9);  // at 2 m/s for 1 s, and the reach; 240 steps' rounding
}

TEST_CASE("while the pointer is beyond the reach the hook goes along with the ball") {
    level::Level level = empty_level(Vec2::Zero());
    level.drag_reach = 2;
    level.scene.drag = {1, 0};
    Session session = session_of(level);
    Vec2 const pointer(1e6, 0);
    game::act(session, game::Grab{0, pointer});
    game::advance_held(session, 0, 1, [&](double) { return pointer; });
    // For 1/60 s each, an undamped spring whose end is 2 m ahead of where the ball then is.
    double const turn = 2 * geometry::pi, angle = turn / 60;
    double place = 0, speed = 0;
    for (int i = 0; i < 60; ++i) {
        place += 2 * (1 - std::cos(angle)) + speed / turn * std::sin(angle);
        speed = 2 * turn * std::sin(angle) + speed * std::cos(angle);
    }
    CHECK(physics::state_at(session.history, 0, 1).position.x() == doctest::Approx(place).epsilon(1e-9));
    REQUIRE(session.inputs.size() == 61);
    for (int i = 1; i <= 60; ++i) {
        CHECK(session.inputs[static_cast<std::size_t>(i)].time == i / 60.0);
        CHECK(std::get<game::Move>(session.inputs[static_cast<std::size_t>(i)].action).pointer == pointer);
    }
}

TEST_CASE("where the hook goes does not hang on how often the window asks, and comes out the same from the run") {
    level::Level level = empty_level(Vec2(-3, 1));
    level.scene.gravity = 9.81;
    auto const pointer = [](double time) { return Vec2(20 - time, 15); };
    for (physics::Method const& method : {physics::Method{physics::Exact{}}, physics::Method{physics::Steps{100, 4}}}) {
        CAPTURE(physics::name_of(method));
        Session once = session_of(level, method), often = session_of(level, method);
        game::act(once, game::Grab{0, pointer(0)});
        game::act(often, game::Grab{0, pointer(0)});
        game::advance_held(once, 0, 1.5, pointer);
        for (int i = 1; i <= 216; ++i) game::advance_held(often, (i - 1) / 144.0, i / 144.0, pointer);
        CHECK(once.inputs.size() == often.inputs.size());
        CHECK(game::state_hash(once, 1.5) == game::state_hash(often, 1.5));
        Session replayed = session_of(level, method, once.inputs);
        game::advance(replayed, 1.5);
        CHECK(game::state_hash(replayed, 1.5) == game::state_hash(once, 1.5));
    }
}

TEST_CASE("once the pointer is within the reach the hook is at the pointer and stays there") {
    level::Level level = empty_level(Vec2::Zero());
    level.drag_reach = 1;
    level.scene.drag = {1, 1};
    Session session = session_of(level);
    Vec2 const pointer(1.25, 0);
    auto const resting = [&](double) { return pointer; };
    game::act(session, game::Grab{0, pointer});
    CHECK(session.world.forces.pull->target == Vec2(1, 0));
    game::advance_held(session, 0, 1, resting);
    CHECK(session.world.forces.pull->target == pointer);
    std::size_t const moves = session.inputs.size();
    game::advance_held(session, 1, 8, resting);
    CHECK(session.inputs.size() == moves);
    // Critically damped, from less than 1.25 m: 1.25 (1 + w t) exp(-w t) at t = 7 s.
    CHECK(geometry::length(physics::state_at(session.history, 0, 8).position - pointer) < 1e-16 + 1e-15);
}

TEST_CASE("tilt beyond the limit is the limit") {
    level::Level level = empty_level(Vec2::Zero());
    level.tilt_limit = 0.3;
    for (auto const& [asked, got] : {std::pair{0.2, 0.2}, {1.0, 0.3}, {-7.0, -0.3}}) {
        Session session = stepped(level, {{0, game::Tilt{asked}}});
        game::advance(session, 0);
        CHECK(session.world.forces.tilt == got);
    }
}

TEST_CASE("a grab of a ball that does not exist is refused with the input's number") {
    std::string const message = message_of([] {
        stepped(empty_level(Vec2::Zero()), {{0, game::Tilt{0}}, {1, game::Grab{1, Vec2(0, 0)}}});
    });
    CHECK(message.find("run.json: inputs[1]: grab: there is no ball 1") == 0);
}

TEST_CASE("what the player does is events in the history, a move is none") {
    Session session = stepped(empty_level(Vec2::Zero()), drag());
    game::advance(session, 1);
    std::vector<physics::EventKind> kinds;
    for (physics::Event const& event : session.history.events) kinds.push_back(event.kind);
    CHECK(kinds == std::vector{physics::EventKind::grab, physics::EventKind::tilt, physics::EventKind::release});
}

TEST_CASE("what was played comes out the same from its run") {
    level::Level const level = empty_level(Vec2(1, 1));
    Session played = stepped(level);
    game::advance(played, 0.1);
    game::act(played, game::Move{Vec2(1, 1)});  // nothing is grabbed, so this is nothing
    game::act(played, game::Grab{0, Vec2(2, 0)});
    game::advance(played, 0.35);
    game::act(played, game::Move{Vec2(0, 3)});
    game::act(played, game::Tilt{0.3});
    game::advance(played, 0.9);
    game::act(played, game::Release{});
    game::advance(played, 1.234);
    game::Run const run = game::run_of(played);
    CHECK(run.inputs.size() == 4);
    CHECK(run.method_name == "steps");
    CHECK(run.rate == 240.0);
    Session replayed = stepped(level, run.inputs);
    game::advance(replayed, run.duration.value());
    CHECK(game::state_hash(replayed, run.final->time) == run.final->state_hash);
}

TEST_CASE("when the player acts, inputs of a run that were to come are dropped") {
    Session session = stepped(empty_level(Vec2::Zero()), drag());
    game::advance(session, 0.2);
    game::act(session, game::Release{});
    game::advance(session, 1);
    CHECK(session.inputs.size() == 2);
    CHECK_FALSE(session.world.forces.pull);
}

TEST_CASE("bananas count from when the rim touches them, the goal from when the centre crosses it") {
    level::Level level = empty_level(Vec2(1, 0));
    add_sensor(level, level::Meaning::banana, physics::DiscRegion{Vec2(2, 0), 0.25}, true);
    add_line(level, level::Meaning::goal, 2);
    Session session = stepped(level);
    game::advance(session, 3);
    // At 1 m/s: 2 - 0.25 - 0.5 s and 2 s; a sensor answers to 1e-11 m and steps add rounding.
    CHECK(std::abs(session.noticed_at[0] - 1.25) <= 1e-9);
    CHECK(std::abs(session.goal_time.value() - 2) <= 1e-9);
    CHECK(game::status_at(session, 1.2).bananas == 0);
    CHECK(game::status_at(session, 1.3).bananas == 1);
    CHECK_FALSE(game::status_at(session, 1.9).goal_time);
    CHECK(game::status_at(session, 2.1).goal_time);
}

TEST_CASE("the game ends at the same time however often one looks, under every method") {
    level::Level level = empty_level(Vec2(1, 0));
    add_line(level, level::Meaning::fall, 0.4);
    add_line(level, level::Meaning::goal, 0.8 - 1e-3);
    level.scene.sensors[0].ball = -1;
    for (physics::Method const& method : {physics::Method(physics::Article{}), physics::Method(physics::Euler{}),
                                          physics::Method(physics::Steps{}), physics::Method(physics::Exact{})}) {
        Session once = session_of(level, method, drag()), often = session_of(level, method, drag());
        game::advance(once, 2);
        for (int i = 0; i <= 120; ++i) {
            game::advance(often, i / 60.0);
            game::forget_before(often, i / 60.0);
        }
        CHECK(once.noticed_at == often.noticed_at);
        CHECK(once.goal_time == often.goal_time);
        CHECK(once.fall_time == often.fall_time);
        CHECK((once.goal_time || once.fall_time));
    }
}

TEST_CASE("a sensor's event that comes in between those judged already is judged") {
    // At 1 s the goal is crossed and gravity turned.
    level::Level level = empty_level(Vec2(1, 0));
    add_line(level, level::Meaning::goal, 1);
    Session session = stepped(level, {{1, game::Tilt{0.1}}});
    game::advance(session, 1);
    game::advance(session, 1 + 1e-9);
    REQUIRE(session.goal_time);
    CHECK(std::abs(*session.goal_time - 1) <= 1e-9);
}

TEST_CASE("what happens first ends the game: no goal after a fall or when time is up") {
    level::Level fallen = empty_level(Vec2(1, 0));
    add_line(fallen, level::Meaning::fall, 1);
    add_line(fallen, level::Meaning::goal, 2);
    Session session = stepped(fallen);
    game::advance(session, 3);
    CHECK(game::status_at(session, 3).fall_time);
    CHECK_FALSE(game::status_at(session, 3).goal_time);

    level::Level late = empty_level(Vec2(1, 0));
    add_line(late, level::Meaning::goal, 2);
    late.time_limit = 1.5;
    session = stepped(late);
    game::advance(session, 3);
    CHECK_FALSE(game::status_at(session, 1.5).out_of_time);
    CHECK(game::status_at(session, 1.6).out_of_time);
    CHECK_FALSE(game::status_at(session, 3).goal_time);
}

TEST_CASE("where nothing can be pulled, a grab is nothing") {
    level::Level level = empty_level(Vec2(1, 0));
    level.drag_reach = 0;
    Session session = stepped(level, drag());
    game::advance(session, 1);
    CHECK(session.pulled_at.empty());
    CHECK(session.forces.back().forces.tilt == 0.2);
    CHECK_FALSE(session.world.forces.pull);
    level.tilt_limit = 0;
    session = stepped(level, drag());
    game::advance(session, 1);
    CHECK(geometry::length(physics::state_at(session.history, 0, 1).position - Vec2(1, 0)) < 1e-12);
}

TEST_CASE("a pull is counted when a ball is taken") {
    level::Level const level = empty_level(Vec2(1, 0));
    std::vector<game::Input> inputs = drag();
    inputs.push_back({0.8, game::Grab{0, Vec2(0, 0)}});
    inputs.push_back({0.9, game::Release{}});
    Session session = stepped(level, inputs);
    game::advance(session, 1);
    CHECK(game::status_at(session, 0.1).pulls == 0);
    CHECK(game::status_at(session, 0.2).pulls == 1);
    CHECK(game::status_at(session, 0.75).pulls == 1);
    CHECK(game::status_at(session, 1).pulls == 2);
}

TEST_CASE("a game taken back to a moment is as it was then, and goes on as it went") {
    level::Level level = empty_level(Vec2(1, 0.3));
    level.scene.gravity = 9.81;
    for (physics::Method const& method : {physics::Method(physics::Exact{}), physics::Method(physics::Steps{})}) {
        Session whole = session_of(level, method, drag());
        game::advance(whole, 2);
        Session earlier = game::rewound(whole, 0.5);
        CHECK(earlier.inputs.size() == 3);
        CHECK(game::state_hash(earlier, 0.5) == game::state_hash(whole, 0.5));
        game::advance(earlier, 0.71);
        game::act(earlier, game::Release{});
        game::advance(earlier, 2);
        bool const is_exact = std::holds_alternative<physics::Exact>(method);
        if (is_exact) CHECK(game::state_hash(earlier, 2) == game::state_hash(whole, 2));
        CHECK(earlier.inputs.size() == 4);
    }
}

TEST_CASE("the state's hash is FNV-1a of its little-endian doubles") {
    // From an independent program.
    CHECK(game::state_hash(std::vector<physics::State>(1)) == "a09d945a1cd8d6e5");
    CHECK(game::state_hash({{Vec2(1, -2), Vec2(0.5, 3), -4, 1e-3}, {Vec2(0.1, 0.2), Vec2(0.3, 0.4), 0.5, 0.6}}) ==
          "2aed326b57bffd4b");
}

TEST_CASE("a method nobody knows is objected to; auto is exact, but for piles") {
    CHECK(game::objection_to({"guess", std::nullopt}));
    CHECK(game::objection_to({std::nullopt, 0.0}));
    CHECK(game::objection_to({std::nullopt, std::nan("")}));
    CHECK_FALSE(game::objection_to({"article", 60.0}));
    CHECK_FALSE(game::objection_to({"exact", std::nullopt}));
    CHECK(game::rate_of(game::method_for({"article", 60.0}, {})) == 60);
    physics::Scene scene;
    scene.balls.resize(3);
    CHECK(std::string(physics::name_of(game::method_for({"auto", std::nullopt}, scene))) == "exact");
    scene.balls.resize(30);
    CHECK(std::string(physics::name_of(game::method_for({"auto", 120.0}, scene))) == "steps");
    CHECK(game::rate_of(game::method_for({"auto", 120.0}, scene)) == 120);
}
