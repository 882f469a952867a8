#include "level/lengths.h"

#include <string>

#include "geometry/elementary.h"
#include "level/css.h"
#include "level/faults.h"

namespace level {

namespace {

struct Unit {
    std::string_view name;
    double size = 1;
};

// CSS Values and Units Level 3, sections 6.2 (in px, which are user units) and 7.1 (in degrees).
constexpr Unit absolute_lengths[] = {{"", 1},           {"px", 1},         {"in", 96},        {"cm", 96 / 2.54},
                                     {"mm", 96 / 25.4}, {"q", 96 / 101.6}, {"pt", 96.0 / 72}, {"pc", 16}};
constexpr Unit angles[] = {{"", 1}, {"deg", 1}, {"grad", 0.9}, {"rad", 180 / geometry::pi}, {"turn", 360}};

template <std::size_t count>
double size_of_unit(Unit const (&units)[count], std::string_view name) {
    for (Unit const& unit : units)
        if (same_word(name, unit.name)) return unit.size;
    throw Broken("unknown unit " + quoted(name));
}

}  // namespace

double length_at(Cursor& cursor, double whole) {
    double const value = cursor.number();
    if (cursor.peek() == '%') {
        cursor.next();
        return value / 100 * whole;
    }
    return value * size_of_unit(absolute_lengths, cursor.word());
}

double angle_at(Cursor& cursor) {
    double const value = cursor.number();
    std::string_view const unit = cursor.word();
    double const size = size_of_unit(angles, unit);
    return value * size;
}

double length_of_text(std::string_view text, double whole) {
    Cursor cursor(trimmed(text));
    double const length = length_at(cursor, whole);
    if (!cursor.at_end()) throw Broken("a length was expected, got " + quoted(text));
    return length;
}

}  // namespace level
