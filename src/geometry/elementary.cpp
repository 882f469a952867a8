#include "geometry/elementary.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace geometry {

namespace {

// pi/2 in three parts; the first two have 33 bits, so their product with a count below 2^20 is exact (Cody, Waite
// 1980).
constexpr double half_pi_high = 0x1.921fb544p+0;
constexpr double half_pi_middle = 0x1.0b4611a6p-34;
constexpr double half_pi_low = 0x1.3198a2e037073p-69;

// ln 2 in two parts; the first has 32 bits.
constexpr double log_two_high = 0x1.62e42feep-1;
constexpr double log_two_low = 0x1.a39ef35793c76p-33;

// Angles beyond this are brought back by whole turns first: the products of their reduction would not be exact.
constexpr double furthest_angle = 1e6;  // rad

// Taylor series for |x| <= pi/4: what is left out is below 5e-17. Their terms are paired, as a single chain of sums
// would wait for itself.
double sine_near_zero(double x) {
    double const s = x * x, s2 = s * s;
    double const low = (-1.0 / 6 + s * (1.0 / 120)) + s2 * (-1.0 / 5040 + s * (1.0 / 362880));
    double const high = (-1.0 / 39916800 + s * (1.0 / 6227020800)) - s2 * (1.0 / 1307674368000);
    return x + x * (s * (low + (s2 * s2) * high));
}

double cosine_near_zero(double x) {
    double const s = x * x, s2 = s * s;
    double const low = (1.0 / 24 - s * (1.0 / 720)) + s2 * (1.0 / 40320 - s * (1.0 / 3628800));
    double const high = (1.0 / 479001600 - s * (1.0 / 87178291200)) + s2 * (1.0 / 20922789888000);
    double const tail = low + (s2 * s2) * high;
    // 1 - s/2 loses up to half a unit in the last place; what it lost is given back with the tail.
    double const half = 0.5 * s;
    double const head = 1 - half;
    return head + (((1 - head) - half) + s2 * tail);
}

// -x if the second bit of `two` is set, else x.
double with_sign(double x, std::uint64_t two) {
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) ^ (two << 62));
}

// exp(x) - 1 - x over x^2 for |x| <= ln 2 / 2, by its Taylor series; even and odd powers apart, for speed.
double exponential_tail(double x) {
    double const s = x * x, s2 = s * s;
    double const even = ((1.0 / 2 + s * (1.0 / 24)) + s2 * (1.0 / 720 + s * (1.0 / 40320))) +
                        (s2 * s2) * (1.0 / 3628800 + s * (1.0 / 479001600));
    double const odd = ((1.0 / 6 + s * (1.0 / 120)) + s2 * (1.0 / 5040 + s * (1.0 / 362880))) +
                       (s2 * s2) * (1.0 / 39916800 + s * (1.0 / 6227020800));
    return even + x * odd;
}

// 2^exponent for -1022 <= exponent <= 1023.
double power_of_two(int exponent) { return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52); }

// arctan(i / 8), i = 0..8.
constexpr double arctangent_of_eighths[9] = {
    0.0,
    0.12435499454676143503,
    0.24497866312686415417,
    0.35877067027057222040,
    0.46364760900080611621,
    0.55859931534356243597,
    0.64350110879328438680,
    0.71882999962162450542,
    0.78539816339744830962,
};

// The angle of (near, far) for 0 <= far <= near: the nearest eighth is taken off, the rest is below 1/16 and has a
// short series.
double arctangent_below_one(double far, double near) {
    int const eighth = static_cast<int>(8 * (far / near) + 0.5);
    double const cut = eighth / 8.0;
    double const x = (far - cut * near) / (near + cut * far);
    double const s = x * x;
    double const tail = -1.0 / 3 + s * (1.0 / 5 + s * (-1.0 / 7 + s * (1.0 / 9 + s * (-1.0 / 11 + s * (1.0 / 13)))));
    return arctangent_of_eighths[eighth] + (x + x * (s * tail));
}

// The series x + x^3/3 + x^5/5 + ... of the hyperbolic arctangent for |x| < 0.18.
double hyperbolic_arctangent_near_zero(double x) {
    double const s = x * x;
    double tail = 0;
    for (int power = 23; power >= 3; power -= 2) tail = (tail + 1.0 / power) * s;
    return x + x * tail;
}

}  // namespace

SineCosine sine_cosine(double angle) {
    if (!(std::abs(angle) <= furthest_angle)) angle = std::remainder(angle, 2 * pi);
    double const count = angle * (2 / pi) + rounder;
    double const quarters = count - rounder;
    double const x = ((angle - quarters * half_pi_high) - quarters * half_pi_middle) - quarters * half_pi_low;
    double const near_zero[2] = {sine_near_zero(x), cosine_near_zero(x)};
    // No branch on the quarter of the turn, which changes too often to be foreseen.
    auto const quarter = std::bit_cast<std::uint64_t>(count);
    return {with_sign(near_zero[quarter & 1], quarter & 2), with_sign(near_zero[~quarter & 1], (quarter + 1) & 2)};
}

double exponential(double x) {
    if (x < -708) return 0;
    if (x > 709) return std::numeric_limits<double>::infinity();
    if (!(x == x)) return x;
    double const doublings = (x * 1.44269504088896340736 + rounder) - rounder;
    double const high = x - doublings * log_two_high;
    double const low = doublings * log_two_low;
    double const rest = high - low;
    double const lost = (high - rest) - low;
    double const scaled = 1 + (rest + (lost + rest * rest * exponential_tail(rest)));
    return scaled * power_of_two(static_cast<int>(doublings));
}

double arctangent(double y, double x) {
    double const width = std::abs(x);
    double const height = std::abs(y);
    double const longer = std::max(width, height);
    if (longer == 0) return 0;
    if (!std::isfinite(width + height)) return (width + height) - (width + height);
    double angle = height <= width ? arctangent_below_one(height, width) : pi / 2 - arctangent_below_one(width, height);
    if (x < 0) angle = pi - angle;
    return y < 0 ? -angle : angle;
}

double arccosine(double x) {
    double const cosine = std::clamp(x, -1.0, 1.0);
    return arctangent(std::sqrt((1 - cosine) * (1 + cosine)), cosine);
}

double logarithm(double x) {
    std::uint64_t const bits = std::bit_cast<std::uint64_t>(x);
    int exponent = static_cast<int>(bits >> 52) - 1023;
    double fraction = std::bit_cast<double>((bits & 0x000fffffffffffffu) | 0x3ff0000000000000u);
    if (fraction > 1.41421356237309504880) {
        fraction *= 0.5;
        ++exponent;
    }
    double const small = 2 * hyperbolic_arctangent_near_zero((fraction - 1) / (fraction + 1));
    return exponent * log_two_high + (exponent * log_two_low + small);
}

double hyperbolic_arctangent(double tangent) {
    if (std::abs(tangent) < 0.17) return hyperbolic_arctangent_near_zero(tangent);
    return 0.5 * logarithm((1 + tangent) / (1 - tangent));
}

}  // namespace geometry
