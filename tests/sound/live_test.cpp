#include "sound/live.h"

#include <cmath>

#include <doctest/doctest.h>

#include "listening.h"

using sound::Gate;
using sound::Live;
using namespace sound_test;

namespace {

// A device that takes 256 samples at a time, and a game that tells 60 times a second what has happened.
struct Stage {
    Live live;
    game::Session session;
    std::vector<float> heard;
    double told = -1;  // s

    explicit Stage(level::Level const& level) : session(session_of(level)) {
        live.begin(sound::world_of(level));
        live.gate(Gate::open);
    }
    void take(double until) {
        constexpr int count = 256;
        while (static_cast<double>(heard.size() / 2 + count) <= until * sound::rate) {
            heard.resize(heard.size() + 2 * count);
            live.fill(heard.data() + heard.size() - 2 * count, count);
        }
    }
    // Up to a time on the wall; the game runs so many seconds of its own in one of these.
    void play(double until, double speed = 1, double frame = 1.0 / 60) {
        double now = static_cast<double>(heard.size() / 2) / sound::rate;
        for (; now < until; now += frame) {
            double const next = std::max(told, 0.0) + speed * frame;
            game::advance(session, next);
            live.hear(session, told, next, frame);
            told = next;
            take(now + frame);
        }
    }
};

double greatest_between(std::vector<float> const& heard, double from, double to) {
    double greatest = 0;
    for (auto i = static_cast<std::size_t>(from * sound::rate) * 2; i < static_cast<std::size_t>(to * sound::rate) * 2;
         ++i)
        greatest = std::max(greatest, static_cast<double>(std::abs(heard[i])));
    return greatest;
}

double greatest_step(std::vector<double> const& samples) {
    double greatest = 0;
    for (std::size_t i = 1; i < samples.size(); ++i)
        greatest = std::max(greatest, std::abs(samples[i] - samples[i - 1]));
    return greatest;
}

}  // namespace

TEST_CASE("what happens in the window is heard within 40 ms, whatever the frame rate down to 30 a second") {
    for (double const frame : {1.0 / 240, 1.0 / 144, 1.0 / 60, 1.0 / 30}) {
        Stage stage(floor_level(1));
        stage.play(0.8, 1, frame);
        double const lands = std::sqrt(2 / 9.81);
        auto const loud =
            std::find_if(stage.heard.begin(), stage.heard.end(), [](float s) { return std::abs(s) > 0.12f; });
        REQUIRE(loud != stage.heard.end());
        double const heard = static_cast<double>((loud - stage.heard.begin()) / 2) / sound::rate;
        // The wood is that loud a few milliseconds after it begins.
        CHECK(heard > lands - frame - 0.006);
        CHECK(heard < lands + 0.04);
    }
}

TEST_CASE("in slow motion a landing is heard as much later") {
    Stage stage(floor_level(1));
    stage.play(2.2, 0.25);
    double const lands = 4 * std::sqrt(2 / 9.81);
    CHECK(greatest_between(stage.heard, 0.1, lands - 0.05) < 0.12);
    CHECK(greatest_between(stage.heard, lands - 0.02, lands + 0.06) > 0.15);
}

TEST_CASE("a shut gate is silence without a click, and the time of the tune stands meanwhile") {
    Stage stage(floor_level(0));
    stage.play(2);
    stage.live.gate(Gate::shut);
    stage.take(2.05);
    stage.take(3);
    CHECK(greatest_between(stage.heard, 1.5, 1.99) > 0.01);
    CHECK(greatest_between(stage.heard, 2.05, 3) == 0);
    stage.live.gate(Gate::open);
    stage.take(4);
    CHECK(greatest_between(stage.heard, 3.1, 4) > 0.01);
    auto const left = left_of(stage.heard);
    CHECK(greatest_step(left) < 0.01);
    // What is played after the pause is what would have been played without it.
    Stage through(floor_level(0));
    through.play(4);
    auto const unbroken = left_of(through.heard);
    bool found = false;
    for (long lag = 45000; lag < 49000 && !found; ++lag) {
        found = true;
        for (std::size_t i = 150000; i < 150100; ++i)
            found = found && left[i] == unbroken[i - static_cast<std::size_t>(lag)];
    }
    CHECK(found);
}

TEST_CASE("another game drops what sounds, without a click, and keeps its world's tune going") {
    Stage stage(floor_level(0));
    stage.play(1);
    auto const before = stage.heard.size();
    stage.live.begin(sound::World::meadow);
    stage.take(1.5);
    CHECK(greatest_step(left_of(stage.heard)) < 0.01);
    Stage through(floor_level(0));
    through.play(1.5);
    auto const later = static_cast<std::ptrdiff_t>(before + 4800);
    CHECK(std::equal(stage.heard.begin() + later, stage.heard.end(), through.heard.begin() + later));
    stage.live.begin(sound::World::night);
    stage.take(2);
    CHECK(greatest_between(stage.heard, 1.6, 2) > 0);
    CHECK(greatest_step(left_of(stage.heard)) < 0.01);
}

TEST_CASE("the volume is a factor, and none is silence") {
    Stage loud(floor_level(0)), soft(floor_level(0)), mute(floor_level(0));
    soft.live.set_volume(0.25);
    mute.live.set_volume(0);
    for (Stage* stage : {&loud, &soft, &mute}) stage->play(1);
    for (std::size_t i = 40000; i < 90000; ++i) {
        REQUIRE(soft.heard[i] == doctest::Approx(0.25 * loud.heard[i]));
        REQUIRE(mute.heard[i] == 0);
    }
}
