#include "game/fraction.h"

#include <charconv>
#include <cmath>
#include <numeric>

namespace game {

namespace {

constexpr double exact_limit = 9007199254740992.0;  // 2^53: below it every whole number is a double

bool is_exact(double whole) { return std::abs(whole) < exact_limit; }

Fraction reduced(double numerator, double denominator) {
    long long const divisor =
        std::gcd(static_cast<long long>(std::abs(numerator)), static_cast<long long>(denominator));
    return {numerator / static_cast<double>(divisor), denominator / static_cast<double>(divisor)};
}

Fraction quotient(Fraction const& a, Fraction const& b) {
    double const numerator = a.numerator * b.denominator;
    double const denominator = a.denominator * b.numerator;
    if (!is_exact(numerator) || !is_exact(denominator)) return {a.value() / b.value(), 1};
    return reduced(numerator, denominator);
}

// The digits as a whole number over a power of ten. `text` is a decimal number already.
Fraction decimal(std::string const& text, double value) {
    std::size_t const mark = text.find_first_of("eE");
    std::string const mantissa = text.substr(0, mark);
    std::size_t const point = mantissa.find('.');
    std::string digits = mantissa;
    int decimals = 0;
    if (point != std::string::npos) {
        digits.erase(point, 1);
        decimals = static_cast<int>(mantissa.size() - point) - 1;
    }
    auto const whole = number_in(digits);
    auto const exponent = mark == std::string::npos ? std::optional<double>(0) : number_in(text.substr(mark + 1));
    if (!whole || !exponent || std::abs(*exponent) > 30) return {value, 1};
    double const shift = *exponent - decimals;
    double numerator = *whole, denominator = 1;
    for (int i = 0; i < std::abs(shift); ++i) (shift > 0 ? numerator : denominator) *= 10;
    if (!is_exact(numerator) || !is_exact(denominator)) return {value, 1};
    return reduced(numerator, denominator);
}

std::optional<Fraction> decimal_in(std::string const& text) {
    auto const value = number_in(text);
    if (!value) return std::nullopt;
    return decimal(text.front() == '+' ? text.substr(1) : text, *value);
}

}  // namespace

std::optional<double> number_in(std::string const& text) {
    bool const plus = !text.empty() && text.front() == '+';
    char const* const begin = text.data() + (plus ? 1 : 0);
    char const* const end = text.data() + text.size();
    if (plus && begin != end && *begin == '-') return std::nullopt;
    double value = 0;
    auto const [stopped, error] = std::from_chars(begin, end, value);
    if (error != std::errc{} || stopped != end || !std::isfinite(value)) return std::nullopt;
    return value;
}

std::optional<Fraction> fraction_in(std::string const& text) {
    std::size_t const slash = text.find('/');
    if (slash == std::string::npos) return decimal_in(text);
    auto const above = decimal_in(text.substr(0, slash));
    auto const below = decimal_in(text.substr(slash + 1));
    if (!above || !below || !(below->value() > 0)) return std::nullopt;
    Fraction const result = quotient(*above, *below);
    if (!std::isfinite(result.value())) return std::nullopt;
    return result;
}

double multiple(long long i, Fraction const& step) {
    return static_cast<double>(i) * step.numerator / step.denominator;
}

double frame_time(Fraction const& from, long long i, Fraction const& rate) {
    // a/b + i d/n = (a n + i d b) / (b n)
    double const first = from.numerator * rate.numerator;
    double const second = static_cast<double>(i) * rate.denominator * from.denominator;
    double const below = from.denominator * rate.numerator;
    if (is_exact(first) && is_exact(second) && is_exact(first + second) && is_exact(below))
        return (first + second) / below;
    return from.value() + static_cast<double>(i) * rate.denominator / rate.numerator;
}

long long frames_between(Fraction const& from, Fraction const& to, Fraction const& rate) {
    double const frames = (to.value() - from.value()) * rate.value();
    double const whole = std::round(frames);
    return static_cast<long long>(std::abs(frames - whole) <= 1e-9 ? whole : std::ceil(frames));
}

}  // namespace game
