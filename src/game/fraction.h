// Times as people type them, kept exact: 1/24, 0.1, 2.5e-3; so that row i stands at the double nearest to i/24.
#pragma once

#include <optional>
#include <string>

namespace game {

// numerator / denominator where both are whole and small enough to be exact; else `nearest` over 1.
struct Fraction {
    double numerator = 0;    // whole, |numerator| < 2^53, unless the text had more digits than that
    double denominator = 1;  // whole, > 0, < 2^53

    double value() const { return numerator / denominator; }
};

// A decimal number or two of them with a slash between. Nothing for other text, for what is not finite and for a
// denominator that is not greater than 0.
std::optional<Fraction> fraction_in(std::string const& text);

// The whole text as a finite decimal number, in the C locale.
std::optional<double> number_in(std::string const& text);

// i * step, rounded once where the products are exact.
double multiple(long long i, Fraction const& step);

// from + i / rate, rounded once where the products are exact, so that a frame's time does not tell where its
// sequence began.
double frame_time(Fraction const& from, long long i, Fraction const& rate);

// ceil((to - from) * rate), where a product within 1e-9 of a whole number is that number.
long long frames_between(Fraction const& from, Fraction const& to, Fraction const& rate);

}  // namespace game
