// Lengths and angles with units, as CSS writes them.
#pragma once

#include <optional>
#include <string_view>

#include "level/numbers.h"

namespace level {

// A length at the cursor in user units: plain, with an absolute unit, or a share of `whole` in per cent.
// Throws Broken for no number and for a unit that depends on fonts or windows.
double length_at(Cursor& cursor, double whole);

// An angle at the cursor in degrees: plain, or in deg, grad, rad or turn. Throws Broken.
double angle_at(Cursor& cursor);

// The whole text as one length. Throws Broken.
double length_of_text(std::string_view text, double whole);

}  // namespace level
