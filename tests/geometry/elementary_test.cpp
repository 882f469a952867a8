#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "geometry/elementary.h"
#include "geometry/oscillator.h"

using namespace geometry;

// The references are the C library's long double functions: 64 bits, 2000 times finer than what is promised.
namespace {

constexpr int elementary_cases = 100000;

double error(double got, long double truth) { return static_cast<double>(std::abs(got - truth)); }

}  // namespace

TEST_CASE("sine and cosine err by at most 1e-15 up to a million radians") {
    std::mt19937_64 random(1);
    double worst = 0;
    for (double const range : {1.0, 10.0, 1e3, 1e6}) {
        std::uniform_real_distribution<double> angle(-range, range);
        for (int i = 0; i < elementary_cases; ++i) {
            double const x = angle(random);
            SineCosine const got = sine_cosine(x);
            worst = std::max({worst, error(got.sine, std::sin(static_cast<long double>(x))),
                              error(got.cosine, std::cos(static_cast<long double>(x)))});
        }
    }
    CHECK(worst <= 1e-15);
    CHECK(sine_cosine(0).sine == 0);
    CHECK(sine_cosine(0).cosine == 1);
    CHECK(std::isnan(sine_cosine(std::numeric_limits<double>::infinity()).sine));
    CHECK(std::abs(sine_cosine(1e200).sine) <= 1);
}

TEST_CASE("the exponential and the logarithm err by at most 1e-15 of themselves") {
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> wide(-708, 709), narrow(-1, 1);
    double worst = 0;
    for (int i = 0; i < elementary_cases; ++i)
        for (double const x : {wide(random), narrow(random)}) {
            long double const truth = std::exp(static_cast<long double>(x));
            worst = std::max(worst, error(exponential(x), truth) / static_cast<double>(truth));
            long double const log_truth = std::log(static_cast<long double>(exponential(x)));
            worst = std::max(worst, error(logarithm(exponential(x)), log_truth) / std::abs(x));
            long double const tangent = narrow(random);
            long double const area = std::atanh(tangent);
            worst = std::max(worst, error(hyperbolic_arctangent(static_cast<double>(tangent)), area) /
                                        static_cast<double>(std::abs(area)));
        }
    CHECK(worst <= 1e-15);
    CHECK(exponential(-1e300) == 0);
    CHECK(exponential(-std::numeric_limits<double>::infinity()) == 0);
    CHECK(exponential(1000) == std::numeric_limits<double>::infinity());
    CHECK(exponential(0) == 1);
}

TEST_CASE("arctangent and arccosine err by at most 1e-15") {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> share(-1, 1);
    double worst = 0;
    for (int i = 0; i < elementary_cases; ++i) {
        double const y = share(random), x = share(random) * (i % 3 == 0 ? 1e-6 : 1);
        worst = std::max({worst, error(arctangent(y, x), std::atan2(static_cast<long double>(y), x)),
                          error(arccosine(y), std::acos(static_cast<long double>(y)))});
    }
    CHECK(worst <= 1e-15);
    CHECK(arctangent(0, 0) == 0);
    CHECK(arctangent(0, -1) == pi);
    CHECK(arccosine(-2) == pi);
    CHECK(arccosine(2) == 0);
}

TEST_CASE("the oscillator follows its closed form in every regime") {
    // Undamped: y0 cos wt; critical: (y0 + (v0 + decay y0) t) e^(-decay t); overdamped 3, 8: rates 2 and 4.
    double const t = 0.7;
    Swing const undamped = swing_after({0, 4}, basis_at({0, 4}, t), {1.5, 0});
    CHECK(undamped.displacement == doctest::Approx(1.5 * std::cos(2 * t)).epsilon(1e-14));
    CHECK(undamped.rate == doctest::Approx(-3 * std::sin(2 * t)).epsilon(1e-14));
    Swing const critical = swing_after({2, 4}, basis_at({2, 4}, t), {1, 3});
    CHECK(critical.displacement == doctest::Approx((1 + 5 * t) * std::exp(-2 * t)).epsilon(1e-14));
    Swing const over = swing_after({3, 8}, basis_at({3, 8}, t), {2, -6});
    CHECK(over.displacement == doctest::Approx(std::exp(-2 * t) + std::exp(-4 * t)).epsilon(1e-14));
    CHECK(over.rate == doctest::Approx(-2 * std::exp(-2 * t) - 4 * std::exp(-4 * t)).epsilon(1e-14));
    Swing const braked = swing_after({1, 0}, basis_at({1, 0}, t), {0, 2});
    CHECK(braked.displacement == doctest::Approx(1 - std::exp(-2 * t)).epsilon(1e-14));
}

TEST_CASE("the envelope of an oscillation is never left, and is reached where nothing damps") {
    // 3 and 4/2: the amplitude of 3 cos 2t + 2 sin 2t.
    CHECK(envelope({0, 4}, {3, 4}) == doctest::Approx(std::sqrt(13.0)).epsilon(1e-15));
    for (Oscillator const& o : {Oscillator(0, 4), Oscillator(0.3, 4), Oscillator(2, 4), Oscillator(5, 4)})
        for (Swing const& start : {Swing{1, 0}, Swing{1, 9}, Swing{-1, 5}, Swing{0, -3}})
            for (int i = 0; i <= 1000; ++i) {
                Swing const later = swing_after(o, basis_at(o, 0.01 * i), start);
                REQUIRE(std::abs(later.displacement) <= envelope(o, start) * (1 + 1e-15));
            }
}

TEST_CASE("a damped oscillator is at rest in the end, whatever its regime") {
    for (double const stiffness : {0.5, 1.0, 4.0})
        for (double const t : {1e4, 1e300, std::numeric_limits<double>::infinity()}) {
            Basis const basis = basis_at({1, stiffness}, t);
            CHECK(basis.cosine_like == 0);
            CHECK(basis.sine_like == 0);
        }
}

TEST_CASE("the regimes meet without a step: near critical damping the basis is that of critical damping") {
    // The basis differs from the critical one by D t^2 / 2 of itself, D = 1 - stiffness.
    for (double const off : {1e-12, -1e-12, 1e-9, -1e-9}) {
        Basis const basis = basis_at({1, 1 + off}, 3);
        CHECK(std::abs(basis.cosine_like - std::exp(-3.0)) <= 1e-15 + 4.5 * std::abs(off));
        CHECK(std::abs(basis.sine_like - 3 * std::exp(-3.0)) <= 1e-15 + 4.5 * std::abs(off));
    }
}
