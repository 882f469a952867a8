#include "level/goal.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "level/convex.h"
#include "level/faults.h"
#include "level/inside.h"
#include "level/outlines.h"
#include "level/round.h"
#include "level/shapes.h"

namespace level {

namespace {

using physics::Region;

constexpr double chord_tolerance = 1e-3;   // m, how far the edge of a goal may be from where it is drawn
constexpr double share_of_size = 1e-4;     // or so much of its size, where that is more
constexpr std::size_t most_corners = 500;  // parting takes their square of time

std::vector<Vec2> corners_along(Outline const& outline, double tolerance) {
    std::vector<Vec2> corners;
    for (geometry::Curve const& curve : outline.curves) {
        int pieces = 1;
        if (auto const* arc = std::get_if<geometry::Arc>(&curve)) {
            // A chord over the angle a lies up to r a^2 / 8 inside of the arc.
            double const angle = std::sqrt(8 * std::min(tolerance / arc->radius, 0.1));
            pieces = std::max(1, static_cast<int>(std::ceil(std::abs(arc->sweep) / angle)));
        }
        for (int i = 0; i < pieces; ++i) corners.push_back(point_along(curve, static_cast<double>(i) / pieces));
    }
    return corners;
}

GoalRegions parts_of(Outline const& outline) {
    geometry::Box const box = box_of(std::span(&outline, 1));
    double const size = geometry::length(box.high - box.low);
    std::vector<Vec2> const corners =
        without_needless(corners_along(outline, std::max(chord_tolerance / 2, size * share_of_size)));
    if (corners.size() < 3) return {};
    if (corners.size() > most_corners)
        throw Broken("it has more than 500 corners; simplify it (Inkscape: Path > Simplify), or draw a rect");
    auto const parts = convex_parts(corners);
    if (parts.empty())
        throw Broken("its outline crosses itself; make it one without crossings (Inkscape: Path > Union)");
    GoalRegions goal;
    for (auto const& part : parts) goal.regions.emplace_back(physics::PolygonRegion{part});
    if (parts.size() > 1) goal.parted = corners.size();
    return goal;
}

std::vector<Region> line_region(std::vector<Vec2> const& ends, Affine const& map) {
    Vec2 const from = placed(map, ends[0]), to = placed(map, ends[1]);
    if (from == to) return {};
    return {physics::LineRegion{from, to}};
}

std::vector<Region> rect_region(std::vector<Vec2> corners, Affine const& map) {
    for (Vec2& corner : corners) corner = placed(map, corner);
    double const area = corners.size() < 4 ? 0 : geometry::cross(corners[1] - corners[0], corners[3] - corners[0]);
    if (area == 0) return {};
    if (area < 0) std::reverse(corners.begin(), corners.end());
    return {physics::PolygonRegion{corners}};
}

}  // namespace

GoalRegions goal_regions(pugi::xml_node node, std::string_view tag, Affine const& to_world, Vec2 const& viewport) {
    if (tag == "line") return {line_region(ends_of_line(node, viewport), to_world)};
    if (tag == "rect" && !has_round_corners(node, viewport))
        return {rect_region(corners_of_rect(node, viewport), to_world)};
    Shape const shape = shape_of(node, tag, viewport);
    if (auto const disc = disc_of(shape, to_world)) return {{*disc}};
    if (tag == "circle") throw Broken(why_not_round(shape, to_world, tag));
    GoalRegions goal;
    for (Outline const& outline : traced(shape, to_world, chord_tolerance / 2).outlines) {
        if (!outline.closed)
            throw Broken(std::string(tag) + " cannot be goal: it is open; close it, or draw a line element");
        GoalRegions parts = parts_of(outline);
        for (Region& region : parts.regions) goal.regions.push_back(std::move(region));
        goal.parted += parts.parted;
    }
    return goal;
}

}  // namespace level
