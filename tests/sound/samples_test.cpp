#include "sound/samples.h"

#include <cmath>

#include <doctest/doctest.h>

#include "listening.h"
#include "sound/noise.h"
#include "sound/timbre.h"
#include "sound/tune.h"

using sound::Note;
using sound::Score;
using sound::Timbre;
using namespace sound_test;

namespace {

Score score_of_note(Note const& note) {
    Score score;
    score.notes = {note};
    return score;
}

// A ball that rolls at one speed, in grains of the ground a second.
Score rolling(double grains_a_second, double loudness, int rows = 800) {
    Score score;
    score.motions.rows.resize(1);
    for (int row = 0; row < rows; ++row) {
        sound::Motion motion;
        motion.roll = loudness;
        motion.way = grains_a_second * row * sound::motion_step / sound::rate;
        score.motions.rows[0].push_back(motion);
    }
    return score;
}

int sign_changes(std::vector<double> const& samples) {
    int count = 0;
    for (std::size_t i = 1; i < samples.size(); ++i) count += (samples[i] > 0) != (samples[i - 1] > 0) ? 1 : 0;
    return count;
}

// All there is at once: notes that begin within blocks, rolling, slipping, a spring, a tune.
Score medley() {
    Score score = rolling(170, 0.2);
    for (sound::Motion& row : score.motions.rows[0]) {
        row.slip = 0.1;
        row.scrape = 0.4;
        row.tension = 0.7;
        row.pan = 0.3;
    }
    for (int i = 0; i < 16; ++i)
        score.notes.push_back({1000LL + 777 * i, static_cast<Timbre>(i), 200.0 + 40 * i, 0.1, 0.8, i / 8.0 - 1});
    score.tune = sound::Playing{sound::World::desert, 333};
    return score;
}

}  // namespace

TEST_CASE("a note's partials stand in the spectrum with the strength of decaying sines") {
    Note const note{0, Timbre::bell, 500, 0.4, 1, 0};
    auto const& partials = sound::voice_of(Timbre::bell).partials;
    constexpr double from = 0.05, length = 1;  // s: after the attack and before the end
    auto const left = left_of(
        sound::samples(score_of_note(note), std::lround(from * sound::rate), std::lround(length * sound::rate)));
    for (sound::Partial const& partial : partials) {
        // |integral of g exp(-d t) sin(w t) exp(-i w t)| = g exp(-d t0) (1 - exp(-d T)) / 2 d, but for what is left of
        // the product at twice the frequency and of the other partials.
        double const expected = 0.4 * std::sqrt(0.5) * partial.gain * std::exp(-partial.decay * from) *
                                (1 - std::exp(-partial.decay * length)) / (2 * partial.decay) * sound::rate;
        CHECK(strength_at(left, 500 * partial.ratio) == doctest::Approx(expected).epsilon(0.05));
    }
    double const weakest = strength_at(left, 500 * partials.back().ratio);
    for (double const nothing : {250.0, 750.0, 1250.0, 1770.0, 4000.0}) CHECK(strength_at(left, nothing) < weakest / 4);
}

TEST_CASE("a note begins at its sample, softly, and ends") {
    for (int timbre = 0; timbre < 16; ++timbre) {
        Note const note{1234, static_cast<Timbre>(timbre), 330, 0.5, 1, 0};
        auto const length = sound::length_of(note);
        auto const heard = sound::samples(score_of_note(note), 0, 1234 + length + 100);
        CHECK(onset_of(heard) == 1234);
        auto const left = left_of(heard);
        double greatest = 0;
        for (double const sample : left) greatest = std::max(greatest, std::abs(sample));
        CHECK(greatest > 0.1);
        CHECK(greatest < 0.5);
        CHECK(std::abs(left[1234]) < 0.03 * greatest);
        CHECK(std::abs(left[static_cast<std::size_t>(1234 + length - 1)]) < 0.01 * greatest);
        for (std::size_t i = static_cast<std::size_t>(1234 + length); i < left.size(); ++i) CHECK(left[i] == 0);
    }
}

TEST_CASE("the pan shares a note's power between the sides") {
    for (double const pan : {-1.0, -0.3, 0.0, 0.6, 1.0}) {
        auto const heard = sound::samples(score_of_note({0, Timbre::bell, 300, 0.3, 1, pan}), 0, 20000);
        double left = 0, right = 0;
        for (std::size_t i = 0; i < heard.size(); i += 2) {
            left += heard[i] * heard[i];
            right += heard[i + 1] * heard[i + 1];
        }
        double const share = std::pow(std::sin((pan + 1) * M_PI / 4), 2);
        CHECK(right / (left + right) == doctest::Approx(share).epsilon(1e-6));
    }
}

TEST_CASE("a stretch of samples by itself is the same as within the whole") {
    Score const score = medley();
    constexpr long long first = -500, count = 40000;
    auto const whole = sound::samples(score, first, count);
    for (long long const from : {-500LL, -1LL, 0LL, 63LL, 64LL, 1000LL, 1777LL, 20001LL})
        for (long long const length : {1LL, 5LL, 64LL, 131LL, 4096LL}) {
            auto const part = sound::samples(score, from, length);
            auto const at = static_cast<std::ptrdiff_t>(2 * (from - first));
            CHECK(std::equal(part.begin(), part.end(), whole.begin() + at));
        }
}

TEST_CASE("what is forgotten is no longer heard, and nothing else") {
    Score score = medley();
    auto const before = sound::samples(score, 15000, 5000);
    auto const notes = score.notes.size();
    sound::forget_before(score, 15000);
    CHECK(score.notes.size() < notes);
    CHECK(score.motions.rows[0].size() < 800);
    CHECK(sound::samples(score, 15000, 5000) == before);
}

TEST_CASE("no sample is beyond 1, however much sounds at once") {
    Score score = medley();
    for (int i = 0; i < 400; ++i) score.notes.push_back({20000, Timbre::marble, 1000.0 + i, 1, 1, 0});
    float greatest = 0;
    for (float const sample : sound::samples(score, 0, 30000)) greatest = std::max(greatest, std::abs(sample));
    CHECK(greatest > 0.9f);
    CHECK(greatest < 1);
}

TEST_CASE("the limiter leaves what is soft alone and bends without a corner") {
    CHECK(sound::limited(0.5) == 0.5);
    CHECK(sound::limited(-0.6) == -0.6);
    CHECK((sound::limited(0.6 + 1e-6) - 0.6) / 1e-6 == doctest::Approx(1).epsilon(1e-4));
    for (double sample = 0; sample < 50; sample += 0.01) CHECK(sound::limited(sample) <= sound::limited(sample + 0.01));
    CHECK(sound::limited(1e9) < 1);
    CHECK(sound::limited(-1e9) > -1);
}

TEST_CASE("twice the speed is an octave higher") {
    // Bands of noise that keep their shape: so many more changes of sign in the same time.
    double const slow = sign_changes(left_of(sound::samples(rolling(100, 0.3), 0, 96000)));
    double const fast = sign_changes(left_of(sound::samples(rolling(200, 0.3), 0, 96000)));
    CHECK(fast / slow == doctest::Approx(2).epsilon(0.1));
}

TEST_CASE("noise is even on both sides of nothing") {
    double sum = 0, squares = 0;
    constexpr int count = 100000;
    for (int i = -count / 2; i < count / 2; ++i) {
        double const number = sound::hashed(i, 7);
        CHECK(std::abs(number) <= 1);
        sum += number;
        squares += number * number;
    }
    CHECK(std::abs(sum / count) < 4 / std::sqrt(3.0 * count));  // four standard deviations of a mean
    CHECK(squares / count == doctest::Approx(1.0 / 3).epsilon(0.02));
}
