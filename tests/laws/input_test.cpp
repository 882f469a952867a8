// T16 and T17: what is no number, what is none of a ball's business, and frames that come late.
#include <cmath>
#include <limits>

#include <doctest/doctest.h>

#include "bounds.h"
#include "game/pace.h"

using namespace laws;

namespace {

// All that the course comes to by `until`, asked for so many times a second, the ball pulled from 1 s to 2 s if at all.
Run played_course(physics::Method const& method, double rate, double until, std::optional<Vec2> const& target) {
    Run run(method, course_at({0, 0}, 0.4));
    for (int i = 1; i <= until * rate; ++i) {
        run.to(i / rate);
        if (target && i == rate) run.pull(0, *target);
        if (target && i == 2 * rate) run.release();
    }
    return run;
}

// Plays the course to 3 s of its own time, a frame of 1/60 s after the other, one of them late by `late` seconds.
struct Play {
    Run run;
    double late_time = 0;  // s, what passed in the late frame
    long long late_steps = 0;
    std::size_t late_events = 0;
};
Play played(physics::Method const& method, double late) {
    Play play{Run(method, course_at({0, 0}, 0.4))};
    game::Pace pace;
    for (int frame = 0; game::simulated_time(pace) < 3; ++frame) {
        double const before = game::simulated_time(pace);
        long long const steps = play.run.world.steps_taken;
        std::size_t const events = play.run.history.events.size();
        pace = game::after(pace, frame == 60 ? 1.0 / 60 + late : 1.0 / 60);
        play.run.to(game::simulated_time(pace));
        if (frame != 60) continue;
        play.late_time = game::simulated_time(pace) - before;
        play.late_steps = play.run.world.steps_taken - steps;
        play.late_events = play.run.history.events.size() - events;
    }
    play.run.to(4);
    return play;
}

}  // namespace

TEST_CASE("T16: what is not finite, and a ball that does not exist, is refused with a reason and changes nothing") {
    for (Bound const& bound : bounds_of(law::lawful_input)) {
        CAPTURE(std::string(physics::name_of(bound.method)));
        Run run(bound.method, course_at({0, 0}, 0.4)), other(bound.method, course_at({0, 0}, 0.4));
        run.to(0.5);
        other.to(0.5);
        for (double const time : {no_number, full_grip, -full_grip}) {
            auto const fault = physics::advance(run.method, run.scene, run.world, time, run.history);
            REQUIRE(fault);
            CHECK_FALSE(fault->why.empty());
        }
        for (double const number : {no_number, full_grip, -full_grip}) {
            CHECK(run.apply({number, {}}));
            CHECK(run.apply({0, physics::Pull{0, {number, 0}}}));
            CHECK(run.apply({0, physics::Pull{0, {0, number}}}));
        }
        for (int const ball : {1, -1, 7}) CHECK(run.apply({0, physics::Pull{ball, {0, 0}}}));
        CHECK(same_bits(run.state(), other.state()));
        for (double const past : {0.5, -5.0}) run.to(past);
        run.to(3);
        other.to(3);
        CHECK(same_bits(run.state(), other.state()));
        CHECK(run.history.events.size() == other.history.events.size());
    }
}

TEST_CASE("T16: times that stand still, creep by 1e-9 s or leap by 10 s come to the same bits") {
    for (Bound const& bound : bounds_of(law::lawful_input)) {
        CAPTURE(std::string(physics::name_of(bound.method)));
        Run creeping(bound.method, course_at({0, 0}, 0.4)), leaping = creeping;
        for (int i = 0; i < 1000; ++i)
            for (double const time : {1e-9 * i, creeping.world.time, 0.0}) creeping.to(time);
        creeping.to(10);
        leaping.to(10);
        CHECK(same_bits(creeping.state(), leaping.state()));
    }
}

TEST_CASE("T16: however often one asks, with a pull from 1 s to 2 s and without, bits and events are the same") {
    for (Bound const& bound : bounds_of(law::lawful_input))
        for (std::optional<Vec2> const& target : {std::optional<Vec2>(), std::optional<Vec2>({1, 4})}) {
            CAPTURE(std::string(physics::name_of(bound.method)));
            Run const coarse = played_course(bound.method, 1, 10, target);
            for (double const rate : {24.0, 60.0, 240.0, 1000.0}) {
                CAPTURE(rate);
                Run const fine = played_course(bound.method, rate, 10, target);
                CHECK(same_bits(fine.state(), coarse.state()));
                CHECK(fine.history.events.size() == coarse.history.events.size());
            }
        }
}

TEST_CASE("T16: pulls of any finite size leave finite states") {
    auto const room = [](double height) {
        return scene_of({line({-1000, 0}, {1000, 0}, material(0.9)), line({5, 0}, {5, 5}), line({-5, 0}, {-5, 5})},
                        {disc_at({0, height})});
    };
    for (Bound const& bound : bounds_of(law::lawful_input))
        for (double const size : {1e-300, 1e-9, 1.0, 1e6, 1e12, 1e300})
            for (bool const in_air : {false, true}) {
                CAPTURE(std::string(physics::name_of(bound.method)));
                CAPTURE(size);
                Run run(bound.method, room(in_air ? 2 : 0.5));
                run.pull(0, {size, size});
                run.to(2);
                CHECK(is_finite(run.state()));
                run.release();
                run.to(10);
                CHECK(is_finite(run.state()));
                CHECK(run.state().position.y() >= 0.5 - 1e-9);
            }
}

TEST_CASE("T16: extreme but lawful numbers stay numbers") {
    for (double const radius : {1e-6, 1e-3, 1e3, 1e6})
        for (double const speed : {0.0, 1.0, 1e6})
            for (double const inertia : {1e-6, 1.0}) {
                physics::Ball ball = disc_at({0, 1.5 * radius}, {speed, -speed}, speed);
                ball.radius = radius;
                ball.inertia = inertia;
                ball.mass = 1e6;
                physics::Ball light = ball;
                light.mass = 1e-6;
                light.start.position.x() = 2.1 * radius;
                auto const of = material(full_grip, 0.99, 0.1);
                double const w = 4 * radius;
                physics::Scene const scene =
                    scene_of({line({-w, 0}, {w, 0}, of), arc({0, w}, w, -pi / 2, 2 * pi, of)}, {ball, light});
                for (Bound const& bound : bounds_of(law::lawful_input)) {
                    Run run(bound.method, scene);
                    run.pull(0, {1, 1});
                    run.to(0.1);
                    for (int i = 0; i < 2; ++i) CHECK(is_finite(run.state(i)));
                }
            }
}

TEST_CASE("T16: a piece of terrain that has no length is none") {
    auto const of = material(0.9);
    for (Bound const& bound : bounds_of(law::lawful_input)) {
        CAPTURE(std::string(physics::name_of(bound.method)));
        Run run(bound.method, scene_of({line({-5, 0}, {1, 0}, of), line({1, 0}, {1, 0}, of),
                                        arc({1, 1}, 1, -pi / 2, 0, of), line({1, 0}, {5, 0}, of)},
                                       {disc_at({0, 0.5}, {1, 0}, -2)}));
        run.to(2);
        CHECK(run.state().position.y() == 0.5);
        CHECK(run.state().velocity.x() == doctest::Approx(1).epsilon(1e-12));
    }
}

TEST_CASE("T17: a frame that comes 2 s late is caught up with by 8 frames of work, and the path stays what it was") {
    for (Bound const& bound : bounds_of(law::late_frame)) {
        CAPTURE(std::string(physics::name_of(bound.method)));
        Play const on_time = played(bound.method, 0), late = played(bound.method, 2);
        CHECK(on_time.late_time == doctest::Approx(1.0 / 60));
        CHECK(late.late_time == doctest::Approx(8.0 / 60));
        CHECK(late.late_steps <= 8 * 4);  // of 1/240 s
        CHECK(late.late_events <= 64);
        CHECK(same_bits(late.run.state(), on_time.run.state()));
        CHECK(late.run.history.events.size() == on_time.run.history.events.size());
    }
}
