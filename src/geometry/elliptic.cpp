#include "geometry/elliptic.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace geometry {

namespace {

// The nome q of k^2 <= 1/2 (Whittaker and Watson 21.8); then q <= 0.0433, and q^12 is below rounding.
double nome(double parameter, double complement) {
    double const k = std::sqrt(complement), root = std::sqrt(k);
    double const e = 0.5 * parameter / ((1 + k) * (1 + root) * (1 + root));
    double const e4 = e * e * e * e;
    return e * (1 + e4 * (2 + e4 * (15 + e4 * 150)));
}

// Carlson's R_F by duplication (Numerical Algorithms 10, 1995), for x, y >= 0 not both zero, z > 0.
double carlson(double x, double y, double z) {
    constexpr double near = 0.01;  // spread at which the series below is exact to rounding
    constexpr int most_duplications = 60;
    double mean = 0, a = 0, b = 0;
    for (int i = 0; i < most_duplications; ++i) {
        mean = (x + y + z) * (1.0 / 3);
        a = 1 - x / mean;
        b = 1 - y / mean;
        if (std::max({std::abs(a), std::abs(b), std::abs(a + b)}) < near) break;
        double const rx = std::sqrt(x), ry = std::sqrt(y), rz = std::sqrt(z);
        double const shift = rx * ry + rz * (rx + ry);
        x = 0.25 * (x + shift);
        y = 0.25 * (y + shift);
        z = 0.25 * (z + shift);
    }
    double const c = -a - b;
    double const e2 = a * b - c * c, e3 = a * b * c;
    double const second = e2 * (-1.0 / 10 + e2 * (1.0 / 24 - e2 * (5.0 / 208)));
    double const third = e3 * (1.0 / 14 - e2 * (3.0 / 44 - e2 * (1.0 / 16)) + e3 * (3.0 / 104));
    return (1 + second + third) / std::sqrt(mean);
}

}  // namespace

Jacobi::Jacobi(double parameter, double complement) : is_near_circular_(parameter <= complement) {
    double const q = is_near_circular_ ? nome(parameter, complement) : nome(complement, parameter);
    double const q2 = q * q, q4 = q2 * q2, q6 = q4 * q2, q9 = q4 * q4 * q, q12 = q6 * q6;
    // Of sin 3v / sin v and so on, in powers of cos 2v.
    odd_ = {1 - q2 - q6 + q12, 4 * (q6 - q12), 2 * (q2 - q6 - 2 * q12), 8 * q12};
    even_ = {1 - 2 * q4, 4 * q4, 2 * q - 6 * q9, 8 * q9};
    double const theta2 = (odd_.e0 + odd_.e2) + (odd_.o0 + odd_.o2);  // at 0, without 2 q^(1/4)
    double const theta3 = (even_.e0 + even_.e2) + (even_.o0 + even_.o2);
    double const theta4 = (even_.e0 + even_.e2) - (even_.o0 + even_.o2);
    scale_ = 1 / (theta3 * theta3);
    if (is_near_circular_) {
        quarter_ = pi / 2 * (theta3 * theta3);
        sn_factor_ = theta3 / theta2;
        cn_factor_ = theta4 / theta2;
        dn_factor_ = theta4 / theta3;
    } else {
        quarter_ = carlson(0, complement, 1);
        sn_factor_ = theta3 / theta4;
        cn_factor_ = theta2 / theta4;
        dn_factor_ = theta2 / theta3;
    }
}

Jacobi::Values Jacobi::at(double u) const {
    double const count = u * (0.5 / quarter_) + rounder;
    double const half_turns = count - rounder;
    double const v = (u - half_turns * (2 * quarter_)) * scale_;
    double sine, cosine;
    if (is_near_circular_) {
        auto const turn = sine_cosine(v);
        sine = turn.sine;
        cosine = turn.cosine;
    } else {
        double const growth = exponential(v), decay = 1 / growth;
        sine = 0.5 * (growth - decay);
        cosine = 0.5 * (growth + decay);
    }
    double const z = 2 * cosine * cosine - 1, z2 = z * z;
    double const odd_even = odd_.e0 + odd_.e2 * z2, odd_odd = z * (odd_.o0 + odd_.o2 * z2);
    double const even_even = even_.e0 + even_.e2 * z2, even_odd = z * (even_.o0 + even_.o2 * z2);
    double const theta1 = sine * (odd_even - odd_odd), theta2 = cosine * (odd_even + odd_odd);
    double const theta3 = even_even + even_odd, theta4 = even_even - even_odd;
    double const sign = (std::bit_cast<std::uint64_t>(count) & 1) == 0 ? 1 : -1;
    // With an imaginary argument theta 2 and 4 change places (Jacobi's imaginary transformation).
    double const below = is_near_circular_ ? theta4 : theta2, across = is_near_circular_ ? theta2 : theta4;
    double const share = 1 / below;
    return {sn_factor_ * theta1 * share, cn_factor_ * across * share, dn_factor_ * theta3 * share, half_turns, sign};
}

double first_kind(double sn, double cn, double dn, double quarter_period) {
    double const u = sn * carlson(cn * cn, dn * dn, 1);
    if (cn >= 0) return u;
    return sn < 0 ? -2 * quarter_period - u : 2 * quarter_period - u;
}

}  // namespace geometry
