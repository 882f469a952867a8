#include "geometry/elliptic.h"

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

using namespace geometry;

namespace {

struct Truth {
    long double sn, cn, dn, quarter;
};

// By descending Landen transformations in long double (Abramowitz and Stegun 16.4), for 1 - k^2 >= 1e-9: below, dn
// loses digits.
Truth truth_at(long double u, long double complement) {
    constexpr int most = 12;
    long double a[most], c[most];
    a[0] = 1;
    c[0] = std::sqrt(1 - complement);
    long double b = std::sqrt(complement);
    int n = 0;
    for (; n + 1 < most && c[n] > 1e-20L; ++n) {
        a[n + 1] = (a[n] + b) / 2;
        c[n + 1] = (a[n] - b) / 2;
        b = std::sqrt(a[n] * b);
    }
    long double const quarter = std::acos(-1.0L) / 2 / a[n];
    long double phi = std::ldexp(a[n] * u, n);
    for (; n > 0; --n) phi = (phi + std::asin(c[n] / a[n] * std::sin(phi))) / 2;
    long double const sn = std::sin(phi);
    return {sn, std::cos(phi), std::sqrt(1 - (1 - complement) * sn * sn), quarter};
}

double difference(double got, long double truth) { return static_cast<double>(std::abs(got - truth)); }

}  // namespace

TEST_CASE("Jacobi's functions err by at most 4e-15 within a period and lead back to their argument") {
    // A few roundings, and what that of the period makes of four quarters.
    for (double const complement : {1.0, 0.999, 0.7, 0.5000001, 0.5, 0.4999, 0.2, 0.01, 1e-5, 1e-9}) {
        CAPTURE(complement);
        Jacobi const jacobi(1 - complement, complement);
        double const k = jacobi.quarter_period();
        for (int i = -400; i <= 400; ++i) {
            double const u = i * 0.01 * k;
            Truth const truth = truth_at(u, complement);
            Jacobi::Values const got = jacobi.at(u);
            double const tolerance = 4e-15 * std::max(1.0, k / 2);
            REQUIRE(difference(k, truth.quarter) <= 1e-15 * k);
            REQUIRE(difference(got.sign * got.sn, truth.sn) <= tolerance);
            REQUIRE(difference(got.sign * got.cn, truth.cn) <= tolerance);
            REQUIRE(difference(got.dn, truth.dn) <= tolerance);
            double const back = first_kind(got.sn, got.cn, got.dn, k) + 2 * k * got.half_turns;
            // du = d am / dn: near a quarter period u is known no better.
            REQUIRE(std::abs(back - u) <= 2 * tolerance / got.dn);
        }
    }
}

TEST_CASE("an almost whole modulus gives the hyperbolic functions") {
    Jacobi const jacobi(1, 1e-22);
    CHECK(jacobi.quarter_period() == doctest::Approx(std::log(4e11)).epsilon(1e-14));
    for (double const u : {-5.0, -0.3, 0.0, 1e-3, 2.0, 9.0}) {
        Jacobi::Values const got = jacobi.at(u);
        CHECK(difference(got.sn, std::tanh(static_cast<long double>(u))) <= 2e-15);
        CHECK(difference(got.cn, 1 / std::cosh(static_cast<long double>(u))) <= 2e-15);
        CHECK(difference(got.dn, 1 / std::cosh(static_cast<long double>(u))) <= 2e-15);
    }
}
