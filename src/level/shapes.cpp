#include "level/shapes.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "level/faults.h"
#include "level/limits.h"
#include "level/numbers.h"

namespace level {

namespace {

double positive_length(pugi::xml_node node, char const* attribute) {
    double const x = length_in(node, attribute);
    if (!(x > 0))
        throw Unsupported(std::string(attribute) + " must be greater than 0, got " +
                          quoted(node.attribute(attribute).value()));
    return x;
}

// A rect without width or height is not drawn; a negative one is a mistake.
double size_of_rect(pugi::xml_node node, char const* attribute) {
    double const x = length_in(node, attribute);
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

// A corner's radius that is missing, or "auto", is the other one.
double corner_radius(pugi::xml_node node, char const* attribute, char const* other) {
    auto const given = [&](char const* name) {
        std::string_view const text = trimmed(node.attribute(name).value());
        return !text.empty() && text != "auto";
    };
    if (given(attribute)) return length_in(node, attribute);
    return given(other) ? length_in(node, other) : 0;
}

Shape rect(pugi::xml_node node) {
    std::vector<Vec2> const points = corners_of_rect(node);
    if (points.empty()) return std::vector<Subpath>();
    if (has_round_corners(node))
        return std::vector{rounded_rect(points, corner_radius(node, "rx", "ry"), corner_radius(node, "ry", "rx"))};
    return std::vector{closed_to_start(joined(points))};
}

std::vector<char const*> coordinates_of(std::string_view tag) {
    if (tag == "path") return {"d"};
    if (tag == "line") return {"x1", "y1", "x2", "y2"};
    if (tag == "rect") return {"x", "y", "width", "height"};
    if (tag == "circle" || tag == "ellipse") return {"cx", "cy"};
    return {"points"};
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

double length_in(pugi::xml_node node, char const* attribute) {
    std::string_view const all = trimmed(node.attribute(attribute).value());
    if (all.empty() && !node.attribute(attribute)) return 0;
    std::string_view text = all;
    if (text.size() > 2 && text.substr(text.size() - 2) == "px") text.remove_suffix(2);
    Parsed const parsed = parsed_number(text);
    if (parsed.syntax == Syntax::good) return parsed.value;
    if (parsed.syntax == Syntax::not_finite)
        throw Broken(std::string(attribute) + " must be finite, got " + quoted(all));
    throw Unsupported(std::string(attribute) + " must be a number, got " + quoted(all));
}

std::string far_coordinates(pugi::xml_node node, std::string_view tag, double scale) {
    std::string all, beyond;
    auto const add = [](std::string& list, char const* name) {
        list += (list.empty() ? "" : ", ") + std::string(name);
    };
    for (char const* const name : coordinates_of(tag)) {
        add(all, name);
        Parsed const parsed = parsed_number(node.attribute(name).value());
        if (std::abs(parsed.value) * scale > most_metres) add(beyond, name);
    }
    return beyond.empty() ? all : beyond;
}

bool has_round_corners(pugi::xml_node node) {
    return corner_radius(node, "rx", "ry") > 0 && corner_radius(node, "ry", "rx") > 0;
}

std::vector<Vec2> corners_of_rect(pugi::xml_node node) {
    double const x = length_in(node, "x"), y = length_in(node, "y");
    double const width = size_of_rect(node, "width"), height = size_of_rect(node, "height");
    if (width == 0 || height == 0) return {};
    return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
}

Shape shape_of(pugi::xml_node node, std::string_view tag) {
    if (tag == "rect") return rect(node);
    if (tag == "circle") {
        double const r = positive_length(node, "r");
        return Ellipse{{length_in(node, "cx"), length_in(node, "cy")}, r, r};
    }
    if (tag == "ellipse")
        return Ellipse{
            {length_in(node, "cx"), length_in(node, "cy")}, positive_length(node, "rx"), positive_length(node, "ry")};
    if (tag == "line")
        return std::vector{
            joined({{length_in(node, "x1"), length_in(node, "y1")}, {length_in(node, "x2"), length_in(node, "y2")}})};
    if (tag == "path") return read_or_name("d", [&] { return parsed_path(node.attribute("d").value()); });
    auto subpaths = read_or_name("points", [&] { return parsed_points(node.attribute("points").value()); });
    if (tag == "polygon")
        for (Subpath& subpath : subpaths) subpath = closed_to_start(std::move(subpath));
    return subpaths;
}

}  // namespace level
