#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>

#include "geometry/swing_roots.h"
#include "support/sanitized.h"

using namespace geometry;

namespace {

constexpr int swing_cases = sanitized ? 100 : 600;
constexpr double never = std::numeric_limits<double>::infinity();
constexpr double right_angle = 1.57079632679489661923;

struct Line {
    double c0, c1;
    Oscillator oscillator;
    Swing start;

    // From the textbook, in long double; between the regimes nothing is asked.
    double at(double t) const {
        long double const decay = oscillator.decay, square = decay * decay - oscillator.stiffness;
        long double const root = std::sqrt(std::abs(square));
        long double cosine = 1, sine = t;
        if (square > 0) cosine = std::cosh(root * t), sine = std::sinh(root * t) / root;
        if (square < 0) cosine = std::cos(root * t), sine = std::sin(root * t) / root;
        long double const y = start.displacement * cosine + (start.rate + decay * start.displacement) * sine;
        return static_cast<double>(c0 + c1 * static_cast<long double>(t) + std::exp(-decay * t) * y);
    }
};

}  // namespace

TEST_CASE("no fall of a line plus a swing is missed or invented, in any regime") {
    std::mt19937_64 random(5);
    auto const within = [&random](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    constexpr double until = 8, step = 0.01;
    for (int i = 0; i < 8 * swing_cases; ++i) {
        double const frequency = std::floor(within(2, 48)) / 4;  // its square is exact, so critical is critical
        double const ratios[4] = {within(0.01, 0.95), 1, within(1.01, 4), 0};
        double const decay = ratios[i % 4] * frequency;
        Line const line{within(-2, 2),
                        i % 8 < 4 ? 0 : within(-1, 1),
                        {decay, frequency * frequency},
                        {within(-2, 2), within(-10, 10)}};
        SwingSearch const found = first_swing_fall(line.c0, line.c1, line.oscillator, line.start, until);
        double const end = found.time ? *found.time : until;
        bool missed = false;
        double last = line.at(0);
        for (double t = step; t < end - 1e-9; t += step) {
            double const value = line.at(t);
            missed = missed || (value < -1e-9 && value < last - 1e-12);
            last = value;
        }
        CHECK_FALSE(missed);
        if (!found.time) continue;
        double const value = line.at(end);
        CHECK(value <= 1e-12);
        // Either a crossing, or a crest below zero: then it is lower just before as well, or this is the start.
        bool const crest = end == 0 || line.at(end - 1e-5) <= value + 1e-12;
        CHECK((value >= -1e-12 || crest));
        CHECK(line.at(end + 1e-5) <= value + 1e-12);
    }
}

TEST_CASE("an undamped swing falls where its cosine says") {
    SwingSearch const fall = first_swing_fall(0, 0, {0, 4}, {1, 0}, never);
    CHECK(*fall.time == doctest::Approx(right_angle / 2).epsilon(1e-15));
    CHECK_FALSE(first_swing_fall(1.5, 0, {0, 4}, {1, 0}, never).time);
    CHECK_FALSE(first_swing_fall(1, 0, {0, 1}, {1, 0}, never).time);  // touches zero each period
}

TEST_CASE("a long swing high above ground is skipped, and the slow line still lands") {
    CHECK(*first_swing_fall(3, -1e-9, {0.1, 100}, {2, 0}, never).time == doctest::Approx(3e9).epsilon(1e-15));
    CHECK(first_swing_fall(3, 1e-9, {0.1, 100}, {2, 0}, never).searched_until == never);
}

TEST_CASE("a swing that dies out above, on or below zero") {
    CHECK_FALSE(first_swing_fall(1, 0, {3, 8}, {1, 0}, never).time);
    CHECK_FALSE(first_swing_fall(0, 0, {1, 1}, {1, 0}, never).time);
    // e^(-2t) + e^(-4t) = 3/4 at e^(-2t) = 1/2
    CHECK(*first_swing_fall(-0.75, 0, {3, 8}, {2, -6}, never).time ==
          doctest::Approx(std::log(2.0) / 2).epsilon(1e-14));
}

TEST_CASE("drag without a spring, and no force at all") {
    // y = v0 (1 - e^(-2 t)) / 2
    CHECK(*first_swing_fall(1, 0, {1, 0}, {0, -3}, never).time == doctest::Approx(std::log(3.0) / 2).epsilon(1e-14));
    CHECK_FALSE(first_swing_fall(1, 0, {1, 0}, {0, -1.9}, never).time);
    CHECK(*first_swing_fall(1, 0, {0, 0}, {0, -1}, never).time == 1);
    CHECK_FALSE(first_swing_fall(0, 0, {1, 1}, {0, 0}, never).time);
}

TEST_CASE("closed and closing falls at once, closed and opening does not") {
    CHECK(first_swing_fall(-1, 0, {0, 1}, {1, -1}, never).time == 0.0);
    CHECK(*first_swing_fall(-1, 0, {0, 1}, {1, 1}, never).time == doctest::Approx(right_angle).epsilon(1e-14));
}

TEST_CASE("a swing let go at its turn falls though rounding has it rise") {
    // The gap 1e-6 closes at acos(1 - 1e-6) / omega whatever the last bit of the speed.
    for (double const speed : {-7e-17, 0.0, 7e-17})
        CHECK(*first_swing_fall(1e-6 - 1, 0, {0, 466}, {1, speed}, never).time ==
              doctest::Approx(std::acos(1 - 1e-6) / std::sqrt(466.0)).epsilon(1e-9));
}
