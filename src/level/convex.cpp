#include "level/convex.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/curve.h"
#include "geometry/elementary.h"

namespace level {

namespace {

using Polygon = std::vector<Vec2>;

constexpr double flat = 1e-12;  // of the product of two sides: less of an area between them is none

double turn(Vec2 const& a, Vec2 const& b, Vec2 const& c) { return geometry::cross(b - a, c - b); }

double flatness_at(Vec2 const& a, Vec2 const& b, Vec2 const& c) {
    return flat * geometry::length(b - a) * geometry::length(c - b);
}

Vec2 const& around(Polygon const& polygon, std::size_t i) { return polygon[i % polygon.size()]; }

double area_of(Polygon const& polygon) {
    double area = 0;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
        area += geometry::cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]) / 2;
    return area;
}

bool is_convex(Polygon const& polygon) {
    double turned = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        Vec2 const &a = polygon[i], &b = around(polygon, i + 1), &c = around(polygon, i + 2);
        if (turn(a, b, c) < -flatness_at(a, b, c)) return false;
        turned += geometry::arctangent(geometry::cross(b - a, c - b), geometry::dot(b - a, c - b));
    }
    return turned < 3 * geometry::pi;  // once round, not twice
}

bool edges_cross(Vec2 const& a, Vec2 const& b, Vec2 const& c, Vec2 const& d) {
    if (!geometry::overlap(geometry::box_of(geometry::Segment{a, b}), geometry::box_of(geometry::Segment{c, d})))
        return false;
    auto const side = [](Vec2 const& p, Vec2 const& q, Vec2 const& r) {
        double const area = geometry::cross(q - p, r - p);
        return area > 0 ? 1 : area < 0 ? -1 : 0;
    };
    return side(a, b, c) * side(a, b, d) <= 0 && side(c, d, a) * side(c, d, b) <= 0;
}

bool crosses_itself(Polygon const& polygon) {
    std::size_t const count = polygon.size();
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = i + 2; j < count; ++j) {
            bool const neighbours = i == 0 && j + 1 == count;
            if (!neighbours && edges_cross(polygon[i], around(polygon, i + 1), polygon[j], around(polygon, j + 1)))
                return true;
        }
    return false;
}

bool is_ear(Polygon const& rest, std::size_t i) {
    std::size_t const count = rest.size();
    Vec2 const &a = rest[(i + count - 1) % count], &b = rest[i], &c = rest[(i + 1) % count];
    if (!(turn(a, b, c) > flatness_at(a, b, c))) return false;
    return std::none_of(rest.begin(), rest.end(), [&](Vec2 const& p) {
        if (p == a || p == b || p == c) return false;
        return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
    });
}

std::vector<Polygon> triangles_of(Polygon rest) {
    std::vector<Polygon> triangles;
    while (rest.size() > 3) {
        std::size_t ear = 0;
        while (ear < rest.size() && !is_ear(rest, ear)) ++ear;
        if (ear == rest.size()) return {};
        std::size_t const count = rest.size();
        triangles.push_back({rest[(ear + count - 1) % count], rest[ear], rest[(ear + 1) % count]});
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(ear));
        rest = without_needless(rest);
    }
    if (rest.size() == 3) triangles.push_back(rest);
    return triangles;
}

// Two polygons that share an edge as one, if that is convex.
std::optional<Polygon> joined(Polygon const& a, Polygon const& b) {
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size(); ++j) {
            if (a[i] != around(b, j + 1) || around(a, i + 1) != b[j]) continue;
            Polygon both;
            for (std::size_t k = 1; k <= a.size(); ++k) both.push_back(around(a, i + k));
            for (std::size_t k = 2; k < b.size(); ++k) both.push_back(around(b, j + k));
            if (is_convex(both)) return both;
            return std::nullopt;
        }
    return std::nullopt;
}

}  // namespace

std::vector<Vec2> without_needless(std::vector<Vec2> const& corners) {
    std::vector<Vec2> kept;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        Vec2 const& before = kept.empty() ? corners.back() : kept.back();
        Vec2 const &here = corners[i], &after = around(corners, i + 1);
        bool const straight = std::abs(turn(before, here, after)) <= flatness_at(before, here, after) &&
                              geometry::dot(here - before, after - here) >= 0;
        if (here != before && !straight) kept.push_back(here);
    }
    return kept;
}

std::vector<Polygon> convex_parts(Polygon corners) {
    if (area_of(corners) < 0) std::reverse(corners.begin(), corners.end());
    if (is_convex(corners)) return {corners};
    if (crosses_itself(corners)) return {};
    std::vector<Polygon> parts = triangles_of(corners);
    for (std::size_t i = 0; i < parts.size(); ++i)
        for (std::size_t j = i + 1; j < parts.size();) {
            auto const both = joined(parts[i], parts[j]);
            if (!both) {
                ++j;
                continue;
            }
            parts[i] = *both;
            parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(j));
            j = i + 1;
        }
    return parts;
}

}  // namespace level
