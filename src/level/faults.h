// What is wrong or suspicious in a level, gathered while it is read.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "level/level.h"

namespace level {

// Thrown inside the reader by what cannot be understood; the reader knows the line and the element.
struct Broken : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// Thrown for what others may read but this program does not: a fault in terrain, no matter in decoration.
struct Unsupported : Broken {
    using Broken::Broken;
};

// Thrown for a place or radius beyond the limit: whoever knows the element adds the attribute's name.
struct TooFar : Broken {
    bool is_radius = false;
    explicit TooFar(std::string const& what, bool radius = false) : Broken(what), is_radius(radius) {}
};

// Findings in the order in which they were met; equal ones once.
class Report {
public:
    void fault(int line, std::string text) { add({line, std::move(text), true}); }
    void warn(int line, std::string text) { add({line, std::move(text), false}); }
    // A warning that nobody should need to ask for.
    void warn_always(int line, std::string text);
    std::vector<Finding> const& findings() const { return findings_; }
    std::vector<Finding> const& misspellings() const { return misspellings_; }
    std::vector<Finding> by_line() const;

private:
    void add(Finding finding);
    std::vector<Finding> findings_;
    std::vector<Finding> misspellings_;
};

// What was found in place of what was wanted: on one line, printable, and not too long.
std::string quoted(std::string_view text);

// A number as a reader would write it, with six significant digits.
std::string shown(double number);

}  // namespace level
