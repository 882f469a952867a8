#include "level/shapes.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "level/css.h"
#include "level/faults.h"
#include "level/lengths.h"
#include "level/limits.h"
#include "level/numbers.h"

namespace level {

namespace {

// A length in user units; `whole` is what per cent are of. Throws Broken naming the attribute.
double length_in(pugi::xml_node node, char const* attribute, double whole) {
    std::string_view const text = trimmed(node.attribute(attribute).value());
    if (text.empty() && !node.attribute(attribute)) return 0;
    Parsed const plain = parsed_number(text);
    if (plain.syntax == Syntax::good) return plain.value;
    if (plain.syntax == Syntax::not_finite)
        throw Broken(std::string(attribute) + " must be finite, got " + quoted(text));
    try {
        double const length = length_of_text(text, whole);
        if (std::isfinite(length)) return length;
    } catch (Broken const&) {
    }
    throw Unsupported(std::string(attribute) + " must be a number, or one with px, mm, cm, in, pt, pc, Q or %, got " +
                      quoted(text));
}

// What per cent of a length that is neither across nor down are of: SVG 2, section 8.9.
double mean_extent(Vec2 const& viewport) { return geometry::length(viewport) / std::sqrt(2); }

double positive(pugi::xml_node node, char const* attribute, double x) {
    if (!(x > 0))
        throw Unsupported(std::string(attribute) + " must be greater than 0, got " +
                          quoted(node.attribute(attribute).value()));
    return x;
}

// A rect without width or height is not drawn; a negative one is a mistake.
double not_negative(pugi::xml_node node, char const* attribute, double whole) {
    double const x = length_in(node, attribute, whole);
    if (x < 0)
        throw Unsupported(std::string(attribute) + " must not be negative, got " +
                          quoted(node.attribute(attribute).value()));
    return x;
}

Subpath joined(std::vector<Vec2> const& points) {
    Subpath subpath;
    subpath.start = points.front();
    for (std::size_t i = 1; i < points.size(); ++i) subpath.draws.push_back(LineTo{points[i]});
    return subpath;
}

Subpath rounded_rect(std::vector<Vec2> const& corners, double rx, double ry) {
    Vec2 const a = corners[0], c = corners[2];
    rx = std::min(rx, (c.x() - a.x()) / 2);
    ry = std::min(ry, (c.y() - a.y()) / 2);
    double const left = a.x(), top = a.y(), right = c.x(), bottom = c.y();
    struct Side {
        Vec2 end, corner_end;
    };
    Side const sides[] = {{{right - rx, top}, {right, top + ry}},
                          {{right, bottom - ry}, {right - rx, bottom}},
                          {{left + rx, bottom}, {left, bottom - ry}},
                          {{left, top + ry}, {left + rx, top}}};
    Subpath subpath;
    subpath.start = {left + rx, top};
    Vec2 at = subpath.start;
    for (Side const& side : sides) {
        if (side.end != at) subpath.draws.push_back(LineTo{side.end});
        subpath.draws.push_back(ArcTo{rx, ry, 0, false, true, side.corner_end});
        at = side.corner_end;
    }
    subpath.closed = true;
    return subpath;
}

// The radii across and down of an ellipse or of a rect's corners: one that is missing, or "auto", is the other.
Vec2 radii_across_and_down(pugi::xml_node node, Vec2 const& viewport) {
    auto const given = [&](char const* name) {
        std::string_view const text = trimmed(node.attribute(name).value());
        return !text.empty() && !same_word(text, "auto");
    };
    bool const has_x = given("rx"), has_y = given("ry");
    double const rx = has_x ? length_in(node, "rx", viewport.x()) : 0;
    double const ry = has_y ? length_in(node, "ry", viewport.y()) : rx;
    return {has_x ? rx : ry, ry};
}

Shape rect(pugi::xml_node node, Vec2 const& viewport) {
    std::vector<Vec2> const points = corners_of_rect(node, viewport);
    if (points.empty()) return std::vector<Subpath>();
    for (char const* const radius : {"rx", "ry"})
        if (!same_word(trimmed(node.attribute(radius).value()), "auto")) not_negative(node, radius, viewport.x());
    Vec2 const radii = radii_across_and_down(node, viewport);
    if (radii.x() > 0 && radii.y() > 0) return std::vector{rounded_rect(points, radii.x(), radii.y())};
    return std::vector{closed_to_start(joined(points))};
}

std::vector<char const*> coordinates_of(std::string_view tag) {
    if (tag == "path") return {"d"};
    if (tag == "line") return {"x1", "y1", "x2", "y2"};
    if (tag == "rect") return {"x", "y", "width", "height"};
    if (tag == "circle" || tag == "ellipse") return {"cx", "cy"};
    return {"points"};
}

std::vector<char const*> radii_of(std::string_view tag) {
    if (tag == "circle") return {"r"};
    if (tag == "ellipse" || tag == "rect") return {"rx", "ry"};
    return coordinates_of(tag);
}

template <typename Read>
std::vector<Subpath> read_or_name(char const* attribute, Read&& read) {
    try {
        return read();
    } catch (Broken const& broken) {
        throw Broken(std::string(attribute) + ": " + broken.what());
    }
}

}  // namespace

bool is_shape(std::string_view tag) {
    return tag == "path" || tag == "line" || tag == "polyline" || tag == "polygon" || tag == "rect" ||
           tag == "circle" || tag == "ellipse";
}

std::string far_attributes(pugi::xml_node node, std::string_view tag, double scale, TooFar const& far) {
    std::string all, beyond;
    auto const add = [](std::string& list, char const* name) {
        list += (list.empty() ? "" : ", ") + std::string(name);
    };
    for (char const* const name : far.is_radius ? radii_of(tag) : coordinates_of(tag)) {
        add(all, name);
        Parsed const parsed = parsed_number(node.attribute(name).value());
        if (std::abs(parsed.value) * scale > most_metres) add(beyond, name);
    }
    return beyond.empty() ? all : beyond;
}

bool has_round_corners(pugi::xml_node node, Vec2 const& viewport) {
    Vec2 const radii = radii_across_and_down(node, viewport);
    return radii.x() > 0 && radii.y() > 0;
}

std::vector<Vec2> corners_of_rect(pugi::xml_node node, Vec2 const& viewport) {
    double const x = length_in(node, "x", viewport.x()), y = length_in(node, "y", viewport.y());
    double const width = not_negative(node, "width", viewport.x()), height = not_negative(node, "height", viewport.y());
    if (width == 0 || height == 0) return {};
    return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
}

std::vector<Vec2> ends_of_line(pugi::xml_node node, Vec2 const& viewport) {
    return {{length_in(node, "x1", viewport.x()), length_in(node, "y1", viewport.y())},
            {length_in(node, "x2", viewport.x()), length_in(node, "y2", viewport.y())}};
}

Shape shape_of(pugi::xml_node node, std::string_view tag, Vec2 const& viewport) {
    if (tag == "rect") return rect(node, viewport);
    auto const centre = [&] { return Vec2(length_in(node, "cx", viewport.x()), length_in(node, "cy", viewport.y())); };
    if (tag == "circle") {
        double const r = positive(node, "r", length_in(node, "r", mean_extent(viewport)));
        return Ellipse{centre(), r, r};
    }
    if (tag == "ellipse") {
        Vec2 const radii = radii_across_and_down(node, viewport);
        return Ellipse{centre(), positive(node, "rx", radii.x()), positive(node, "ry", radii.y())};
    }
    if (tag == "line") return std::vector{joined(ends_of_line(node, viewport))};
    if (tag == "path") return read_or_name("d", [&] { return parsed_path(node.attribute("d").value()); });
    auto subpaths = read_or_name("points", [&] { return parsed_points(node.attribute("points").value()); });
    if (tag == "polygon")
        for (Subpath& subpath : subpaths) subpath = closed_to_start(std::move(subpath));
    return subpaths;
}

}  // namespace level
