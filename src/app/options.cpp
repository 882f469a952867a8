#include "app/options.h"

#include <charconv>

#include "app/command.h"

namespace app {

namespace {

constexpr double longest_time = 1e9;      // s, as in run files
constexpr long long longest_side = 8192;  // pixels, what a software renderer is sure to have

std::optional<long long> whole_number_in(std::string const& text) {
    long long value = 0;
    auto const [stopped, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || stopped != text.data() + text.size()) return std::nullopt;
    return value;
}

[[noreturn]] void refuse(std::string const& option, std::string const& text, std::string const& wanted) {
    throw UsageError(option + " must be " + wanted + ", got \"" + text + "\"");
}

}  // namespace

void declare(Subcommand& command, MethodOptions& options) {
    command.takes("--method", options.method, "auto, article, euler, steps or exact (default: the run's, else auto)",
                  "NAME");
    command.takes("--rate", options.rate, "steps a second (default: the run's, else 240)", "HZ");
    command.takes("--tolerance", options.tolerance,
                  "deepest error wanted (of piles, overlap): steps takes a rate that keeps it", "METRES");
}

game::MethodWish wish_from(MethodOptions const& options) {
    game::MethodWish wish;
    wish.name = options.method;
    if (options.rate) wish.rate = positive_fraction_from("--rate", *options.rate).value();
    if (options.tolerance) wish.tolerance = positive_fraction_from("--tolerance", *options.tolerance).value();
    if (auto const objection = game::objection_to(wish)) throw UsageError(*objection);
    return wish;
}

game::Fraction fraction_from(std::string const& option, std::string const& text) {
    auto const fraction = game::fraction_in(text);
    if (!fraction) refuse(option, text, "a number or a fraction such as 1/24");
    return *fraction;
}

game::Fraction positive_fraction_from(std::string const& option, std::string const& text) {
    game::Fraction const fraction = fraction_from(option, text);
    if (!(fraction.value() > 0)) refuse(option, text, "greater than 0");
    return fraction;
}

game::Fraction time_from(std::string const& option, std::string const& text) {
    game::Fraction const time = fraction_from(option, text);
    if (time.value() < 0 || time.value() > longest_time) refuse(option, text, "a time from 0 to 1e9 seconds");
    return time;
}

long long whole_number_from(std::string const& option, std::string const& text, long long low, long long high) {
    auto const value = whole_number_in(text);
    if (!value || *value < low || *value > high)
        refuse(option, text, "a whole number from " + std::to_string(low) + " to " + std::to_string(high));
    return *value;
}

Size size_from(std::string const& text) {
    std::size_t const cross = text.find_first_of("xX");
    auto const width = whole_number_in(text.substr(0, cross));
    auto const height = cross == std::string::npos ? std::nullopt : whole_number_in(text.substr(cross + 1));
    auto const fits = [](std::optional<long long> side) { return side && *side >= 1 && *side <= longest_side; };
    if (!fits(width) || !fits(height)) refuse("--size", text, "WIDTHxHEIGHT in pixels, each from 1 to 8192");
    return {static_cast<int>(*width), static_cast<int>(*height)};
}

}  // namespace app
