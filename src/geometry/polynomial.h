// When a polynomial gap closes: the first crossing from above zero to below it, by brackets between the roots of the
// derivative.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "geometry/vector.h"

namespace geometry {

// Coefficients are given lowest power first; at most `most_coefficients` of them.
inline constexpr int most_coefficients = 25;

inline double value_at(std::span<double const> polynomial, double t) {
    double value = 0;
    for (auto c = polynomial.rbegin(); c != polynomial.rend(); ++c) value = value * t + *c;
    return value;
}

// The first t in [0, until] at which the gap is not above zero and is closing (physics.md 11.1): a crossing from
// + to -, or 0 for a gap that is closed and closing at the start, or the crest of a gap that opens but stays below zero.
// A gap that merely touches zero, or starts at zero and opens, is no event there. `until` may be infinite.
// The gap at the answer is zero up to the rounding of its own terms.
std::optional<double> first_fall(std::span<double const> gap, double until);

// Every t in (0, until) at which the polynomial changes its sign, in order, up to the rounding of its own terms.
struct Crossings {
    int count = 0;
    std::array<double, most_coefficients> at;
    std::span<double const> all() const { return std::span<double const>(at).first(static_cast<std::size_t>(count)); }
};
Crossings crossings(std::span<double const> polynomial, double until);

// The same polynomial counted from t.
template <std::size_t N>
std::array<double, N> counted_from(double t, std::array<double, N> p) {
    for (std::size_t done = 0; done + 1 < N; ++done)
        for (std::size_t i = N - 1; i-- > done;) p[i] += t * p[i + 1];
    return p;
}

// first_fall of c0 + c1 t + c2 t^2 in closed form.
inline std::optional<double> first_quadratic_fall(double c0, double c1, double c2, double until) {
    double t = 0;
    double const discriminant = c1 * c1 - 4 * c2 * c0;
    if (c0 > 0 && c1 < 0) {
        if (c2 > 0 && !(discriminant > 0)) return std::nullopt;
        t = 2 * c0 / (std::sqrt(discriminant) - c1);
    } else if (c0 > 0 || c1 > 0) {
        if (!(c2 < 0)) return std::nullopt;
        t = discriminant > 0 ? (c1 + std::sqrt(discriminant)) / (-2 * c2) : c1 / (-2 * c2);
    } else if (!(c1 < 0 || (c1 == 0 && c2 < 0))) {
        return std::nullopt;
    }
    if (t <= until && t < std::numeric_limits<double>::infinity()) return t;
    return std::nullopt;
}

// |position + velocity t + acceleration t^2 / 2|^2 - radius^2, without the cancellation of p.p - R^2 (physics.md 8.1).
inline std::array<double, 5> distance_quartic(Vec2 const& position, Vec2 const& velocity, Vec2 const& acceleration,
                                              double radius) {
    double const distance = length(position);
    return {(distance - radius) * (distance + radius), 2 * dot(position, velocity),
            dot(velocity, velocity) + dot(position, acceleration), dot(velocity, acceleration),
            dot(acceleration, acceleration) / 4};
}

}  // namespace geometry
