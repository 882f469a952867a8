#include "sound/tune.h"

#include <cmath>
#include <set>

#include <doctest/doctest.h>

#include "listening.h"

using sound::Playing;
using sound::World;
using namespace sound_test;

namespace {

constexpr World worlds[] = {World::meadow, World::desert, World::ice, World::night};

}  // namespace

TEST_CASE("a tune begins anew, to the sample, after its loop") {
    for (World const world : worlds) {
        Playing const tune{world, 1000};
        long long const loop = sound::loop_of(world);
        auto const second = sound::tune_notes(tune, 1000 + loop, 1000 + 2 * loop);
        auto const third = sound::tune_notes(tune, 1000 + 2 * loop, 1000 + 3 * loop);
        REQUIRE(second.size() > 50);
        REQUIRE(second.size() == third.size());
        for (std::size_t i = 0; i < second.size(); ++i) {
            CHECK(second[i].start + loop == third[i].start);
            CHECK(second[i].pitch == third[i].pitch);
            CHECK(second[i].loudness == third[i].loudness);
        }
    }
}

TEST_CASE("notes that begin in two stretches are those of both") {
    Playing const tune{World::ice, 500};
    auto const whole = sound::tune_notes(tune, 0, 900000);
    auto const first = sound::tune_notes(tune, 0, 331234), rest = sound::tune_notes(tune, 331234, 900000);
    REQUIRE(first.size() + rest.size() == whole.size());
    CHECK(first.back().start < 331234);
    CHECK(rest.front().start >= 331234);
}

TEST_CASE("a tune keeps to its world's scale, and is quiet") {
    std::set<std::set<int>> scales;
    for (World const world : worlds) {
        std::set<int> scale;
        for (sound::Note const& note : sound::tune_notes({world, 0}, 0, sound::loop_of(world))) {
            double const semitones = 12 * std::log2(note.pitch / 440);
            CHECK(semitones == doctest::Approx(std::round(semitones)).epsilon(1e-9));
            scale.insert((static_cast<int>(std::lround(semitones)) + 120) % 12);
            CHECK(note.pitch > 40);
            CHECK(note.pitch < 2500);
        }
        CHECK(scale.size() <= 7);
        CHECK(scale.size() >= 5);
        scales.insert(scale);
        sound::Score score;
        score.tune = Playing{world, 0};
        auto const heard = left_of(sound::samples(score, 5 * sound::rate, 10 * sound::rate));
        CHECK(std::sqrt(power_of(heard)) > 0.008);
        CHECK(std::sqrt(power_of(heard)) < 0.06);
    }
    CHECK(scales.size() == 4);
}

TEST_CASE("the root of the meadow's scale is middle C, and octaves double") {
    CHECK(sound::pitch_in(World::meadow, 0) == doctest::Approx(440 * std::pow(2, -9.0 / 12)));
    for (World const world : worlds)
        for (int step = -7; step < 14; ++step)
            CHECK(sound::pitch_in(world, step + 7) == doctest::Approx(2 * sound::pitch_in(world, step)));
}
