#include "level/transform.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "geometry/elementary.h"
#include "level/css.h"
#include "level/faults.h"
#include "level/lengths.h"
#include "level/numbers.h"

namespace level {

namespace {

// Exact at quarter turns, which are what drawings are full of.
geometry::SineCosine turn_by_degrees(double degrees) {
    double const rest = std::fmod(degrees, 360.0);
    double const angle = rest < 0 ? rest + 360 : rest;
    if (angle == 0) return {0, 1};
    if (angle == 90) return {1, 0};
    if (angle == 180) return {0, -1};
    if (angle == 270) return {-1, 0};
    return geometry::sine_cosine(angle * (geometry::pi / 180));
}

double tangent_of_degrees(double degrees) {
    geometry::SineCosine const turn = turn_by_degrees(degrees);
    if (turn.cosine == 0) throw Broken("a skew by a quarter turn");
    return turn.sine / turn.cosine;
}

enum class Kind { number, x, y, angle };

// What the arguments of a function are; the last kind goes on. Names as CSS has them, in lower case.
struct Function {
    std::string_view name;
    std::array<Kind, 3> kinds;
};
constexpr Function functions[] = {
    {"matrix", {Kind::number, Kind::number, Kind::number}}, {"translate", {Kind::x, Kind::y, Kind::number}},
    {"translatex", {Kind::x, Kind::number, Kind::number}},  {"translatey", {Kind::y, Kind::number, Kind::number}},
    {"scale", {Kind::number, Kind::number, Kind::number}},  {"scalex", {Kind::number, Kind::number, Kind::number}},
    {"scaley", {Kind::number, Kind::number, Kind::number}}, {"rotate", {Kind::angle, Kind::x, Kind::y}},
    {"skew", {Kind::angle, Kind::angle, Kind::number}},     {"skewx", {Kind::angle, Kind::number, Kind::number}},
    {"skewy", {Kind::angle, Kind::number, Kind::number}}};

Function const& function_named(std::string_view name) {
    for (Function const& function : functions)
        if (same_word(name, function.name)) return function;
    throw Broken("unknown function " + quoted(name));
}

Affine rotation(std::vector<double> const& numbers) {
    geometry::SineCosine const turn = turn_by_degrees(numbers[0]);
    Affine const about_origin{turn.cosine, turn.sine, -turn.sine, turn.cosine, 0, 0};
    return numbers.size() == 1 ? about_origin : about({numbers[1], numbers[2]}, about_origin);
}

Affine map_of(std::string_view name, std::vector<double> const& n) {
    std::size_t const count = n.size();
    bool const one = count == 1, one_or_two = count == 1 || count == 2;
    double const second = count == 2 ? n[1] : 0;
    if (name == "matrix" && count == 6) return {n[0], n[1], n[2], n[3], n[4], n[5]};
    if (name == "translate" && one_or_two) return {1, 0, 0, 1, n[0], second};
    if (name == "translatex" && one) return {1, 0, 0, 1, n[0], 0};
    if (name == "translatey" && one) return {1, 0, 0, 1, 0, n[0]};
    if (name == "scale" && one_or_two) return {n[0], 0, 0, count == 2 ? n[1] : n[0], 0, 0};
    if (name == "scalex" && one) return {n[0], 0, 0, 1, 0, 0};
    if (name == "scaley" && one) return {1, 0, 0, n[0], 0, 0};
    if (name == "rotate" && (count == 1 || count == 3)) return rotation(n);
    if (name == "skew" && one_or_two) return {1, tangent_of_degrees(second), tangent_of_degrees(n[0]), 1, 0, 0};
    if (name == "skewx" && one) return {1, 0, tangent_of_degrees(n[0]), 1, 0, 0};
    if (name == "skewy" && one) return {1, tangent_of_degrees(n[0]), 0, 1, 0, 0};
    throw Broken(std::string(name) + " has " + std::to_string(count) + " numbers, which is not its number");
}

double argument(Cursor& cursor, Kind kind, Vec2 const& whole) {
    switch (kind) {
        case Kind::x:
            return length_at(cursor, whole.x());
        case Kind::y:
            return length_at(cursor, whole.y());
        case Kind::angle:
            return angle_at(cursor);
        case Kind::number:
            break;
    }
    return cursor.number();
}

std::vector<double> arguments(Cursor& cursor, Function const& function, Vec2 const& whole) {
    cursor.skip_spaces();
    if (cursor.next() != '(') throw Broken("( was expected");
    std::vector<double> numbers;
    cursor.skip_spaces();
    while (cursor.peek() != ')') {
        if (!numbers.empty()) cursor.skip_separator();
        Kind const kind = function.kinds[std::min<std::size_t>(numbers.size(), 2)];
        numbers.push_back(argument(cursor, kind, whole));
        cursor.skip_spaces();
    }
    cursor.next();
    return numbers;
}

// One coordinate of an origin: a side of the box, its middle, or a length from its corner.
struct Coordinate {
    enum class Axis { either, x, y } axis = Axis::either;
    std::string_view text;
};

Coordinate coordinate_of(std::string_view word) {
    if (same_word(word, "left")) return {Coordinate::Axis::x, "0%"};
    if (same_word(word, "right")) return {Coordinate::Axis::x, "100%"};
    if (same_word(word, "top")) return {Coordinate::Axis::y, "0%"};
    if (same_word(word, "bottom")) return {Coordinate::Axis::y, "100%"};
    return {Coordinate::Axis::either, same_word(word, "center") ? "50%" : word};
}

}  // namespace

Affine about(Vec2 const& point, Affine const& map) {
    Affine const to{1, 0, 0, 1, point.x(), point.y()}, back{1, 0, 0, 1, -point.x(), -point.y()};
    return composed(to, composed(map, back));
}

Affine composed(Affine const& o, Affine const& i) {
    return {o.a * i.a + o.c * i.b, o.b * i.a + o.d * i.b,       o.a * i.c + o.c * i.d,
            o.b * i.c + o.d * i.d, o.a * i.e + o.c * i.f + o.e, o.b * i.e + o.d * i.f + o.f};
}

Vec2 mapped(Affine const& map, Vec2 const& point) {
    return {map.a * point.x() + map.c * point.y() + map.e, map.b * point.x() + map.d * point.y() + map.f};
}

Vec2 mapped_direction(Affine const& map, Vec2 const& direction) {
    return {map.a * direction.x() + map.c * direction.y(), map.b * direction.x() + map.d * direction.y()};
}

double determinant(Affine const& map) { return map.a * map.d - map.b * map.c; }

double scale_of(Affine const& map) { return std::sqrt(std::abs(determinant(map))); }

bool is_similarity(Affine const& map) {
    double const slack =
        similarity_slack * std::max({std::abs(map.a), std::abs(map.b), std::abs(map.c), std::abs(map.d)});
    bool const turns = std::abs(map.a - map.d) <= slack && std::abs(map.b + map.c) <= slack;
    bool const mirrors = std::abs(map.a + map.d) <= slack && std::abs(map.b - map.c) <= slack;
    return turns || mirrors;
}

Affine parsed_transform(std::string_view text, Vec2 const& whole) {
    Cursor cursor(trimmed(text));
    Affine map;
    for (std::string_view const word : {"none", "initial", "unset", "revert"})
        if (same_word(cursor.rest(), word)) return map;
    while (!cursor.at_end()) {
        std::string_view const name = cursor.word();
        if (name.empty()) throw Broken("a function was expected, got " + quoted(cursor.rest()));
        Function const& function = function_named(name);
        map = composed(map, map_of(function.name, arguments(cursor, function, whole)));
        cursor.skip_spaces();
        if (cursor.peek() != ',') continue;
        cursor.skip_separator();
        if (cursor.at_end()) throw Broken("a function was expected after the comma");
    }
    return map;
}

Affine parsed_function(std::string_view name, std::string_view arguments, Vec2 const& whole) {
    std::string const text = std::string(name) + "(" + std::string(arguments) + ")";
    return same_word(arguments, "none") ? Affine{} : parsed_transform(text, whole);
}

Vec2 parsed_origin(std::string_view text, ReferenceBox const& box) {
    using Axis = Coordinate::Axis;
    std::vector<std::string_view> const words = word_list(text);
    // A third value is depth, which a drawing has none of.
    if (words.empty() || words.size() > 3) throw Broken("two lengths were expected, got " + quoted(text));
    Coordinate x = coordinate_of(words[0]), y{Axis::y, "50%"};
    if (words.size() > 1) y = coordinate_of(words[1]);
    if (x.axis == Axis::y || y.axis == Axis::x) std::swap(x, y);
    if (x.axis == Axis::y || y.axis == Axis::x) {
        if (words.size() > 1) throw Broken("two lengths were expected, got " + quoted(text));
        x = {Axis::x, "50%"};
    }
    return box.corner + Vec2(length_of_text(x.text, box.size.x()), length_of_text(y.text, box.size.y()));
}

}  // namespace level
