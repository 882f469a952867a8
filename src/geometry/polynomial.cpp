#include "geometry/polynomial.h"

#include "geometry/bracket.h"

#include <algorithm>
#include <cassert>

namespace geometry {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Share of t within which an extremum is placed: the value there errs by its square, which is below rounding.
constexpr double extremum_share = 1e-9;
// Share of t within which the event itself is placed.
constexpr double event_share = 2.5e-16;

// Where a polynomial changes sign, and its sign just after 0 (0 for the zero polynomial).
struct SignChanges : Crossings {
    int sign = 0;

    void add(double t) { at[count++] = t; }
};

Slope slope_at(std::span<double const> p, double t) {
    Slope slope;
    for (auto c = p.rbegin(); c != p.rend(); ++c) {
        slope.rate = slope.rate * t + slope.value;
        slope.value = slope.value * t + *c;
    }
    return slope;
}

double root_of(std::span<double const> p, Bracket const& bracket, double share) {
    return root_in([p](double t) { return slope_at(p, t); }, bracket, share);
}

// Whether the terms against the lowest one cannot outweigh it anywhere in (0, until]: no root, no sign change.
bool keeps_sign(std::span<double const> p, double until) {
    int const sign = sign_of(p[0]);
    double power = 1;
    double against = 0;
    for (std::size_t i = 1; i < p.size(); ++i) {
        power *= until;
        if (sign_of(p[i]) * sign < 0) against += std::abs(p[i]) * power;
    }
    return against < std::abs(p[0]);
}

std::span<double const> without_leading_zeros(std::span<double const> p) {
    while (!p.empty() && p.back() == 0) p = p.first(p.size() - 1);
    return p;
}

std::span<double const> derivative_of(std::span<double const> p, std::array<double, most_coefficients>& room) {
    for (std::size_t i = 1; i < p.size(); ++i) room[i - 1] = static_cast<double>(i) * p[i];
    return std::span<double const>(room).first(p.size() - 1);
}

// The end of the last monotone stretch, if it is endless: any time by which the polynomial has its final sign.
double settled_after(std::span<double const> p, double from) {
    int const final_sign = sign_of(p.back());
    double t = from > 0 ? 2 * from : 1.0;
    while (t < 1e300 && sign_of(value_at(p, t)) != final_sign) t *= 8;
    return t;
}

void add_quadratic_sign_changes(std::span<double const> p, double until, SignChanges& changes) {
    double const c2 = p.size() > 2 ? p[2] : 0;
    double const discriminant = p[1] * p[1] - 4 * c2 * p[0];
    if (!(discriminant > 0)) return;
    double const q = -0.5 * (p[1] + (p[1] < 0 ? -std::sqrt(discriminant) : std::sqrt(discriminant)));
    double const one = p[0] / q;
    double const other = c2 == 0 ? infinity : q / c2;
    for (double const t : {std::min(one, other), std::max(one, other)})
        if (t > 0 && t < until) changes.add(t);
}

SignChanges sign_changes(std::span<double const> p, double until, double share) {
    SignChanges changes;
    p = without_leading_zeros(p);
    while (!p.empty() && p.front() == 0) p = p.subspan(1);  // a root at 0 itself changes no sign after it
    if (p.empty()) return changes;
    changes.sign = sign_of(p.front());
    if (p.size() == 1 || keeps_sign(p, until)) return changes;
    if (p.size() <= 3) {
        add_quadratic_sign_changes(p, until, changes);
        return changes;
    }
    std::array<double, most_coefficients> room;
    SignChanges const turns = sign_changes(derivative_of(p, room), until, extremum_share);
    Bracket bracket{0, 0, p.front(), 0, changes.sign};
    for (int i = 0; i <= turns.count; ++i) {
        bracket.high = i < turns.count ? turns.at[i] : until;
        if (bracket.high == infinity) bracket.high = settled_after(p, bracket.low);
        bracket.high_value = value_at(p, bracket.high);
        bool const crosses = sign_of(bracket.high_value) * bracket.low_sign < 0;
        if (crosses) changes.add(root_of(p, bracket, share));
        bracket = {bracket.high, 0, bracket.high_value, 0, crosses ? -bracket.low_sign : bracket.low_sign};
    }
    return changes;
}

}  // namespace

Crossings crossings(std::span<double const> polynomial, double until) {
    assert(polynomial.size() <= most_coefficients);
    return sign_changes(polynomial, until, event_share);
}

std::optional<double> first_fall(std::span<double const> gap, double until) {
    assert(gap.size() <= most_coefficients);
    gap = without_leading_zeros(gap);
    if (gap.size() < 2 || !(until >= 0)) return std::nullopt;
    if (gap.size() <= 3) return first_quadratic_fall(gap[0], gap[1], gap.size() > 2 ? gap[2] : 0, until);
    if (gap[0] > 0 && keeps_sign(gap, until)) return std::nullopt;
    std::array<double, most_coefficients> room;
    SignChanges const turns = sign_changes(derivative_of(gap, room), until, extremum_share);
    bool closing = turns.sign < 0;
    Bracket bracket{0, 0, gap[0], 0, 1};
    for (int i = 0; i <= turns.count; ++i) {
        if (closing && !(bracket.low_value > 0)) return bracket.low;
        bracket.high = i < turns.count ? turns.at[i] : until;
        if (bracket.high == infinity) bracket.high = settled_after(gap, bracket.low);
        bracket.high_value = value_at(gap, bracket.high);
        if (closing && bracket.high_value < 0) return root_of(gap, bracket, event_share);
        closing = !closing;
        bracket = {bracket.high, 0, bracket.high_value, 0, 1};
    }
    return std::nullopt;
}

}  // namespace geometry
