#include "level/numbers.h"

#include <algorithm>
#include <charconv>
#include <clocale>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>
#include <version>

#include "level/faults.h"

namespace level {

namespace {

constexpr std::string_view spaces = " \t\r\n\f";

bool is_space(char c) { return spaces.find(c) != std::string_view::npos; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

// Of a number without a sign; too large for a double is infinity, too small 0. Both ways round correctly, so that they
// come to the same bits.
#ifdef __cpp_lib_to_chars
// from_chars says "out of range" for the too small as well as the too large, and leaves the value alone.
double out_of_range(std::string_view number) {
    std::size_t const exponent = number.find_first_of("eE");
    bool const small = exponent == std::string_view::npos ? number.find_first_of("123456789") > number.find('.')
                                                          : number.substr(exponent + 1, 1) == "-";
    return small ? 0 : std::numeric_limits<double>::infinity();
}

double value_of(std::string_view number) {
    double value = 0;
    auto const error = std::from_chars(number.data(), number.data() + number.size(), value).ec;
    return error == std::errc::result_out_of_range ? out_of_range(number) : value;
}
#else  // libc++ 14
double value_of(std::string_view number) {
    static locale_t const plain = newlocale(LC_ALL_MASK, "C", nullptr);
    return strtod_l(std::string(number).c_str(), nullptr, plain);
}
#endif

struct Prefix {
    double value = 0;
    std::size_t length = 0;  // 0: no number
};

std::size_t digits_at(std::string_view text, std::size_t at) {
    std::size_t count = 0;
    while (at + count < text.size() && is_digit(text[at + count])) ++count;
    return count;
}

Prefix number_at_start(std::string_view text) {
    std::size_t const sign = !text.empty() && (text[0] == '+' || text[0] == '-') ? 1 : 0;
    std::size_t end = sign + digits_at(text, sign);
    std::size_t digits = end - sign;
    if (text.substr(end, 1) == ".") {
        std::size_t const decimals = digits_at(text, end + 1);
        if (decimals == 0) return {};  // CSS Values, SVG 2: digits must follow the point
        digits += decimals;
        end += 1 + decimals;
    }
    if (digits == 0) return {};
    if (end < text.size() && (text[end] == 'e' || text[end] == 'E')) {
        std::size_t const power_sign = end + 1 < text.size() && (text[end + 1] == '+' || text[end + 1] == '-') ? 1 : 0;
        std::size_t const power = digits_at(text, end + 1 + power_sign);
        if (power > 0) end += 1 + power_sign + power;
    }
    double const value = value_of(text.substr(sign, end - sign));
    return {text[0] == '-' ? -value : value, end};
}

}  // namespace

std::string_view trimmed(std::string_view text) {
    std::size_t const first = text.find_first_not_of(spaces);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(spaces) - first + 1);
}

Words::Iterator::Iterator(std::string_view rest) : rest_(rest) { ++*this; }

Words::Iterator& Words::Iterator::operator++() {
    std::size_t const first = rest_.find_first_not_of(spaces);
    word_ = {};
    if (first == std::string_view::npos) return *this;
    std::size_t const end = std::min(rest_.find_first_of(spaces, first), rest_.size());
    word_ = rest_.substr(first, end - first);
    rest_ = rest_.substr(end);
    return *this;
}

std::vector<std::string_view> word_list(std::string_view text) {
    std::vector<std::string_view> words;
    for (std::string_view const word : words_of(text)) words.push_back(word);
    return words;
}

void Cursor::skip_spaces() {
    while (!at_end() && is_space(text_[at_])) ++at_;
}

void Cursor::skip_separator() {
    skip_spaces();
    if (peek() != ',') return;
    ++at_;
    skip_spaces();
}

bool Cursor::begins_number() const { return number_at_start(rest()).length > 0; }

double Cursor::number() {
    Prefix const prefix = number_at_start(rest());
    if (prefix.length == 0) throw Broken("a number was expected, got " + quoted(rest()));
    if (!std::isfinite(prefix.value))
        throw Broken("a number must be finite, got " + quoted(rest().substr(0, prefix.length)));
    at_ += prefix.length;
    return prefix.value;
}

std::string_view Cursor::word() {
    std::size_t const first = at_;
    while (!at_end() && is_letter(text_[at_])) ++at_;
    return text_.substr(first, at_ - first);
}

Parsed parsed_number(std::string_view text) {
    text = trimmed(text);
    Prefix const prefix = number_at_start(text);
    if (prefix.length > 0 && prefix.length == text.size())
        return {prefix.value, std::isfinite(prefix.value) ? Syntax::good : Syntax::not_finite};
    std::string name(text.substr(!text.empty() && (text[0] == '+' || text[0] == '-') ? 1 : 0));
    std::transform(name.begin(), name.end(), name.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? c + 32 : c; });
    bool const infinite = name == "inf" || name == "infinity";
    if (infinite) return {std::numeric_limits<double>::infinity() * (text[0] == '-' ? -1 : 1), Syntax::not_finite};
    return {0, name == "nan" ? Syntax::not_finite : Syntax::not_a_number};
}

std::optional<std::vector<double>> parsed_list(std::string_view text) {
    Cursor cursor(trimmed(text));
    std::vector<double> numbers;
    while (!cursor.at_end()) {
        Prefix const prefix = number_at_start(cursor.rest());
        if (prefix.length == 0 || !std::isfinite(prefix.value)) return std::nullopt;
        numbers.push_back(cursor.number());
        std::size_t const before = cursor.rest().size();
        cursor.skip_separator();
        bool const ends_in_comma = cursor.at_end() && cursor.rest().size() != before;
        if (ends_in_comma) return std::nullopt;
    }
    return numbers;
}

}  // namespace level
