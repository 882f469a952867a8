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

// In an attribute names have one spelling, and translateX, scaleY and skew are not known.
bool is_of_attributes(std::string_view name) {
    constexpr std::string_view names[] = {"matrix", "translate", "scale", "rotate", "skewX", "skewY"};
    return std::find(std::begin(names), std::end(names), name) != std::end(names);
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

class TransformReader {
public:
    TransformReader(std::string_view text, Vec2 const& whole) : cursor_(trimmed(text)), whole_(whole) {}

    Transform read() {
        for (std::string_view const word : {"none", "initial", "unset", "revert"})
            if (same_word(cursor_.rest(), word)) return {};
        while (!cursor_.at_end()) {
            std::string_view const name = function_name();
            if (!is_of_attributes(name)) transform_.in_attribute = false;
            Function const& function = function_named(name);
            std::vector<double> const numbers = arguments(function);
            if (function.name == "rotate" && numbers.size() > 1) transform_.in_style = false;
            transform_.map = composed(transform_.map, map_of(function.name, numbers));
            cursor_.skip_spaces();
            if (cursor_.peek() != ',') continue;
            transform_.in_style = false;
            cursor_.skip_separator();
            if (cursor_.at_end()) throw Broken("a function was expected after the comma");
        }
        return transform_;
    }

private:
    std::string_view function_name() {
        std::string_view const rest = cursor_.rest();
        std::string_view const name = rest.substr(0, rest.find_first_of("( \t\r\n,)"));
        bool const begins_with_letter = !cursor_.word().empty();
        if (!begins_with_letter) throw Broken("a function was expected, got " + quoted(rest));
        if (cursor_.rest().size() + name.size() != rest.size()) throw Broken("unknown function " + quoted(name));
        return name;
    }

    std::vector<double> arguments(Function const& function) {
        cursor_.skip_spaces();
        if (cursor_.next() != '(') throw Broken("( was expected");
        std::vector<double> numbers;
        cursor_.skip_spaces();
        while (cursor_.peek() != ')') {
            if (!numbers.empty()) {
                if (cursor_.peek() != ',') transform_.in_style = false;
                cursor_.skip_separator();
            }
            numbers.push_back(argument(function.kinds[std::min<std::size_t>(numbers.size(), 2)]));
            cursor_.skip_spaces();
        }
        cursor_.next();
        return numbers;
    }

    double argument(Kind kind) {
        std::string_view const before = cursor_.rest();
        double const plain = cursor_.number();
        std::size_t const digits = before.size() - cursor_.rest().size();
        if (kind == Kind::number) {
            if (cursor_.peek() != '%') return plain;
            cursor_.next();
            transform_.in_attribute = false;
            return plain / 100;
        }
        cursor_ = Cursor(before);
        double const value =
            kind == Kind::angle ? angle_at(cursor_) : length_at(cursor_, kind == Kind::x ? whole_.x() : whole_.y());
        bool const has_unit = before.size() - cursor_.rest().size() > digits;
        if (has_unit) transform_.in_attribute = false;
        if (!has_unit && plain != 0) transform_.in_style = false;
        return value;
    }

    Cursor cursor_;
    Vec2 whole_;
    Transform transform_;
};

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

Transform parsed_transform(std::string_view text, Vec2 const& whole) { return TransformReader(text, whole).read(); }

Affine parsed_function(std::string_view name, std::string_view arguments, Vec2 const& whole) {
    if (arguments.empty() || same_word(arguments, "none")) return {};
    return parsed_transform(std::string(name) + "(" + std::string(arguments) + ")", whole).map;
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
