#include "level/transform.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "geometry/elementary.h"
#include "level/faults.h"
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

Affine rotation(std::vector<double> const& numbers) {
    geometry::SineCosine const turn = turn_by_degrees(numbers[0]);
    Affine const about_origin{turn.cosine, turn.sine, -turn.sine, turn.cosine, 0, 0};
    if (numbers.size() == 1) return about_origin;
    Affine const to{1, 0, 0, 1, numbers[1], numbers[2]}, back{1, 0, 0, 1, -numbers[1], -numbers[2]};
    return composed(to, composed(about_origin, back));
}

Affine function_of(std::string_view name, std::vector<double> const& n) {
    std::size_t const count = n.size();
    if (name == "matrix" && count == 6) return {n[0], n[1], n[2], n[3], n[4], n[5]};
    if (name == "translate" && (count == 1 || count == 2)) return {1, 0, 0, 1, n[0], count == 2 ? n[1] : 0};
    if (name == "scale" && (count == 1 || count == 2)) return {n[0], 0, 0, count == 2 ? n[1] : n[0], 0, 0};
    if (name == "rotate" && (count == 1 || count == 3)) return rotation(n);
    if (name == "skewX" && count == 1) return {1, 0, tangent_of_degrees(n[0]), 1, 0, 0};
    if (name == "skewY" && count == 1) return {1, tangent_of_degrees(n[0]), 0, 1, 0, 0};
    bool const known = name == "matrix" || name == "translate" || name == "scale" || name == "rotate" ||
                       name == "skewX" || name == "skewY";
    if (known) throw Broken(std::string(name) + " has " + std::to_string(count) + " numbers, which is not its number");
    throw Broken("unknown function " + quoted(name));
}

std::vector<double> arguments(Cursor& cursor) {
    cursor.skip_spaces();
    if (cursor.next() != '(') throw Broken("( was expected");
    std::vector<double> numbers;
    cursor.skip_spaces();
    while (cursor.peek() != ')') {
        if (!numbers.empty()) cursor.skip_separator();
        numbers.push_back(cursor.number());
        cursor.skip_spaces();
    }
    cursor.next();
    return numbers;
}

}  // namespace

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

Affine parsed_transform(std::string_view text) {
    Cursor cursor(trimmed(text));
    Affine map;
    if (cursor.rest() == "none") return map;
    while (!cursor.at_end()) {
        std::string_view const name = cursor.word();
        if (name.empty()) throw Broken("a function was expected, got " + quoted(cursor.rest()));
        map = composed(map, function_of(name, arguments(cursor)));
        cursor.skip_separator();
    }
    return map;
}

}  // namespace level
