#include "level/in_sight.h"

#include <algorithm>

#include "level/inside.h"

namespace level {

namespace {

// m, positive to the left of the way from a to b, which differ.
double left_of_line(Vec2 const& a, Vec2 const& b, Vec2 const& point) {
    return geometry::cross(b - a, point - a) / geometry::length(b - a);
}

bool holds_point(Sight const& sight, Vec2 const& point) {
    constexpr double slack = 1e-6;  // m
    if (sight.size() < 3) return false;
    for (std::size_t i = 0; i < sight.size(); ++i) {
        Vec2 const &a = sight[i], &b = sight[(i + 1) % sight.size()];
        if (a != b && left_of_line(a, b, point) < -slack) return false;
    }
    return true;
}

}  // namespace

Sight sight_of(geometry::Box const& rect, Affine const& to_world) {
    Sight sight = {mapped(to_world, rect.low), mapped(to_world, {rect.high.x(), rect.low.y()}),
                   mapped(to_world, rect.high), mapped(to_world, {rect.low.x(), rect.high.y()})};
    if (determinant(to_world) < 0) std::reverse(sight.begin(), sight.end());
    return sight;
}

Sight common_part(Sight const& a, Sight const& b) {
    constexpr std::size_t most_corners = 64;
    Sight rest = a;
    for (std::size_t i = 0; i < b.size(); ++i) {
        Vec2 const &from = b[i], &to = b[(i + 1) % b.size()];
        if (from == to) continue;
        Sight kept;
        for (std::size_t k = 0; k < rest.size(); ++k) {
            Vec2 const &here = rest[k], &next = rest[(k + 1) % rest.size()];
            double const side = left_of_line(from, to, here), next_side = left_of_line(from, to, next);
            if (side >= 0) kept.push_back(here);
            if (side * next_side < 0) kept.push_back(here + (next - here) * (side / (side - next_side)));
        }
        rest = std::move(kept);
    }
    return rest.size() > most_corners ? a : rest;
}

bool holds(Sight const& sight, std::span<Outline const> outlines) {
    constexpr int parts = 32;
    for (Outline const& outline : outlines)
        for (geometry::Curve const& curve : outline.curves) {
            int const steps = std::holds_alternative<geometry::Arc>(curve) ? parts : 1;
            for (int i = 0; i <= steps; ++i)
                if (!holds_point(sight, point_along(curve, static_cast<double>(i) / steps))) return false;
        }
    return true;
}

}  // namespace level
