// Options that several subcommands share: as typed, and what the typed words mean. Every reader throws UsageError.
#pragma once

#include <optional>
#include <string>

#include "app/command_line.h"
#include "game/fraction.h"
#include "game/method_choice.h"

namespace app {

struct MethodOptions {
    std::optional<std::string> method, rate, tolerance;
};
void declare(Subcommand& command, MethodOptions& options);
game::MethodWish wish_from(MethodOptions const& options);

// A decimal number or a fraction such as 1/24. `option` is named in the error.
game::Fraction fraction_from(std::string const& option, std::string const& text);
game::Fraction positive_fraction_from(std::string const& option, std::string const& text);
game::Fraction time_from(std::string const& option, std::string const& text);  // s, at least 0, at most 1e9

long long whole_number_from(std::string const& option, std::string const& text, long long low, long long high);

struct Size {
    int width = 1280, height = 720;  // pixels
};
Size size_from(std::string const& text);

}  // namespace app
