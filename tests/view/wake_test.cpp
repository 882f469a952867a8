#include <cmath>

#include <doctest/doctest.h>

#include "stages.h"
#include "view/actors.h"
#include "view/effects.h"

using view::Vec2;
using namespace view_test;

namespace {

constexpr double wake_rounding = 1e-9;

physics::Leg leg_of(double since, physics::Phase phase, physics::State const& from) {
    physics::Leg leg = steady_leg(from, since);
    leg.phase = phase;
    return leg;
}
physics::History history_of(physics::Leg const& leg) {
    physics::History history;
    history.legs.push_back({leg});
    return history;
}
physics::State at_floor(Vec2 const& velocity, double spin = 0) { return {{8, 1.5}, velocity, 0, spin}; }

// One motion up to `when`, another from there on.
physics::History changed_history(physics::Phase before, physics::State from, double when, physics::Phase after,
                                 Vec2 const& velocity) {
    physics::History history = history_of(leg_of(0, before, from));
    history.legs[0][0].until = when;
    from.position += when * from.velocity;
    from.angle += when * from.spin;
    from.velocity = velocity;
    history.legs[0].push_back(leg_of(when, after, from));
    return history;
}

physics::History bounced_history(double speed) {
    physics::History history = changed_history(physics::Phase::flight, {{8, 1.5 + speed}, {0, -speed}, 0, 0}, 1,
                                               physics::Phase::flight, Vec2(0, speed / 2));
    physics::Event event;
    event.time = 1;
    event.kind = physics::EventKind::bounce;
    history.events.push_back(event);
    return history;
}

view::Monkey monkey_at(level::Level const& level, physics::History const& history, double time,
                       std::optional<Vec2> const& pointer = std::nullopt) {
    view::Camera const camera{level.size / 2, 80, Vec2(1280, 720)};
    view::Moment const moment = view::moment_at(level, history, time);
    return all_of<view::Shell>(view::ball_shapes(level, moment, camera, pointer)).at(0).monkey;
}

}  // namespace

TEST_CASE("a ball that leaves the ground comes loose along the integral of the kernel") {
    level::Level const level = floor_level(16, 9);
    physics::History const history =
        changed_history(physics::Phase::roll, at_floor({0, 0}), 1, physics::Phase::flight, Vec2::Zero());
    CHECK(view::wake_of(level, history, 0, 0.9).loose == 0);
    for (double const u : {0.2, 0.5, 0.8}) {
        double const share = 6 * u * u - 8 * u * u * u + 3 * u * u * u * u;
        CHECK(view::wake_of(level, history, 0, 1 + 0.5 * u).loose == doctest::Approx(share).epsilon(wake_rounding));
    }
    CHECK(view::wake_of(level, history, 0, 2).loose == doctest::Approx(1).epsilon(wake_rounding));
}

TEST_CASE("a hard bounce throws sparks for a moment, a soft one none") {
    level::Level const level = floor_level(16, 9);
    physics::History const hard = bounced_history(6), soft = bounced_history(1.5);
    CHECK(view::wake_of(level, hard, 0, 0.99).sparks.empty());
    CHECK(view::wake_of(level, hard, 0, 1.1).sparks.size() >= 5);
    CHECK(view::wake_of(level, hard, 0, 1.5).sparks.empty());
    CHECK(view::wake_of(level, soft, 0, 1.1).sparks.empty());
    // They leave the ground where it was touched.
    for (view::Fleck const& spark : view::wake_of(level, hard, 0, 1.02).sparks) {
        CHECK(spark.way.y() > 0);
        CHECK(geometry::length(spark.place - Vec2(8, 1)) < 0.3);
    }
}

TEST_CASE("a ball that slips raises dust where it touches, one that rolls does not") {
    level::Level const level = floor_level(16, 9);
    auto const wake = [&](physics::Phase phase, double spin) {
        physics::Leg leg = leg_of(0, phase, at_floor({3, 0}, spin));
        leg.contact = {0, 1};
        return view::wake_of(level, history_of(leg), 0, 1);
    };
    CHECK(wake(physics::Phase::slide, 0).dust.size() > 10);
    CHECK(wake(physics::Phase::roll, -6).dust.empty());
    CHECK(wake(physics::Phase::slide, -6).dust.empty());  // 3 m/s at the rim of half a metre: nothing slips
    for (view::Fleck const& fleck : wake(physics::Phase::slide, 0).dust) {
        CHECK(fleck.place.y() > 1);
        CHECK(fleck.place.y() < 2.5);
        CHECK(fleck.place.x() < 12);
    }
}

TEST_CASE("a fast ball has a trail along its path, a slow one none") {
    level::Level const level = floor_level(16, 9);
    CHECK(view::wake_of(level, steady_history(at_floor({2, 0})), 0, 1).trail.empty());
    view::Wake const wake = view::wake_of(level, steady_history(at_floor({15, 0})), 0, 1);
    CHECK(wake.haste == doctest::Approx(1));
    REQUIRE(wake.trail.size() > 10);
    for (Vec2 const& place : wake.trail) CHECK(place.y() == doctest::Approx(1.5));
    CHECK(wake.trail.back().x() == doctest::Approx(8 + 15));
}

TEST_CASE("what is seen of the past needs no more of it than is said") {
    level::Level const level = floor_level(16, 9);
    physics::History const history = bounced_history(9);
    physics::History late = history;
    physics::forget_before(late, 1.2 - view::wake_memory);
    view::Wake const whole = view::wake_of(level, history, 0, 1.2), part = view::wake_of(level, late, 0, 1.2);
    CHECK(whole.loose == part.loose);
    CHECK(whole.push == part.push);
    CHECK(whole.trail == part.trail);
    REQUIRE(whole.sparks.size() == part.sparks.size());
    for (std::size_t i = 0; i < whole.sparks.size(); ++i) CHECK(whole.sparks[i].place == part.sparks[i].place);
}

TEST_CASE("the monkey of a rolling ball stays upright and runs, whatever its shell does") {
    level::Level const level = floor_level(16, 9);
    physics::History const history = history_of(leg_of(0, physics::Phase::roll, at_floor({2, 0}, -4)));
    for (double time = 1; time < 3; time += 0.1) {
        view::Monkey const monkey = monkey_at(level, history, time);
        CHECK(std::abs(monkey.lean) < 0.15);
        CHECK(monkey.swing == doctest::Approx(1));
    }
    CHECK(monkey_at(level, history, 1).stride != doctest::Approx(monkey_at(level, history, 1.1).stride));
    CHECK(monkey_at(level, steady_history(at_floor({0, 0})), 1).swing == 0);
}

TEST_CASE("the monkey of a ball that spins through the air goes round with it") {
    level::Level const level = floor_level(16, 9);
    physics::History const history = history_of(leg_of(0, physics::Phase::flight, at_floor({0, 0}, 5)));
    for (double const time : {1.0, 1.3, 2.2}) {
        double const difference = monkey_at(level, history, time).lean - 5 * time;
        CHECK(std::cos(difference) == doctest::Approx(1).epsilon(wake_rounding));
    }
}

TEST_CASE("the monkey leans into a push") {
    level::Level const level = floor_level(16, 9);
    physics::Leg leg = leg_of(0, physics::Phase::roll, at_floor({0, 0}));
    leg.motion = physics::Ballistic{at_floor({0, 0}), Vec2(4, 0), 0};
    physics::History const history = history_of(leg);
    CHECK(view::wake_of(level, history, 0, 1).push.x() == doctest::Approx(4).epsilon(1e-6));
    CHECK(monkey_at(level, history, 1).lean < -0.1);  // to the right
}

TEST_CASE("the monkey looks at the pointer, else where the ball goes, and blinks by simulated time") {
    level::Level const level = floor_level(16, 9);
    physics::History const still = steady_history(at_floor({0, 0}));
    Vec2 const ball(640, 600);  // pixels
    Vec2 const up = monkey_at(level, still, 1, ball - Vec2(0, 300)).gaze;
    CHECK(up.x() == doctest::Approx(0));
    CHECK(up.y() == doctest::Approx(-1));
    CHECK(monkey_at(level, still, 1).gaze == Vec2(0, 0));
    CHECK(monkey_at(level, steady_history(at_floor({0, 5})), 0.1).gaze.y() < -0.5);
    double shut = 0, open = 0;
    for (double time = 0; time < 6; time += 0.01) (monkey_at(level, still, time).blink > 0.5 ? shut : open) += 0.01;
    CHECK(shut > 0.05);
    CHECK(shut < 0.5);
}
