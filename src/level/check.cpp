#include "level/check.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "geometry/elementary.h"
#include "level/inside.h"

namespace level {

namespace {

using geometry::Arc;
using physics::IncidentEdge;
using physics::Terrain;
using physics::Vertex;

std::string shown_at(Vec2 const& point) {
    return std::string("(").append(shown(point.x())).append(", ").append(shown(point.y())).append(")");
}

class Check {
public:
    explicit Check(Reading& reading)
        : reading_(reading), level_(reading.level), scene_(reading.level.scene), terrain_(scene_.terrain) {}

    void all() {
        gaps();
        tangent_breaks();
        tight_arcs();
        balls_inside();
        out_of_view();
    }

private:
    int line_of_piece(int piece) const { return reading_.surfaces[terrain_.pieces[piece].surface].line; }
    void warn_of_piece(int piece, std::string const& what) {
        reading_.report.warn(line_of_piece(piece), "terrain: " + what);
    }

    std::span<Outline const> outlines_of(Surface const& surface) const {
        return std::span(level_.outlines).subspan(surface.first_outline, surface.outlines);
    }

    void gaps() {
        for (Vertex const& vertex : terrain_.vertices)
            if (vertex.edges.size() == 1) gap_at(vertex);
    }

    // From a loose end to the nearest terrain that it does not touch; its own piece counts where that is a ring that
    // does not quite close.
    void gap_at(Vertex const& vertex) {
        int const own = vertex.edges[0].piece;
        double nearest = widest_gap;
        int found = -1;
        terrain_.tree.each_overlapping(geometry::grown({vertex.point, vertex.point}, widest_gap), [&](int piece) {
            if (piece == own) return;
            double const distance = geometry::nearest_point(terrain_.pieces[piece].curve, vertex.point).distance;
            if (distance < nearest) {
                nearest = distance;
                found = piece;
            }
        });
        int const other_end = vertex.edges[0].at_start ? terrain_.end_vertex[own] : terrain_.start_vertex[own];
        double const to_itself = geometry::length(terrain_.vertices[other_end].point - vertex.point);
        bool const is_ring = to_itself < nearest && geometry::length_of(terrain_.pieces[own].curve) > 2 * widest_gap;
        if (is_ring) {
            nearest = to_itself;
            found = own;
        }
        if (found < 0 || nearest <= physics::vertex_reach) return;
        warn_of_piece(own, "a gap of " + shown(nearest) + " m at " + shown_at(vertex.point));
    }

    // A polyline that stands for a curve has a break at every point: its first one speaks for all.
    void tangent_breaks() {
        struct Breaks {
            int count = 0;
            std::string first;
        };
        std::vector<Breaks> by_surface(reading_.surfaces.size());
        for (Vertex const& vertex : terrain_.vertices)
            if (auto const found = tangent_break_at(vertex)) {
                Breaks& breaks = by_surface[terrain_.pieces[found->piece].surface];
                if (breaks.count++ > 0) continue;
                breaks.first = shown(found->turn * 180 / geometry::pi) + " degrees at " + shown_at(vertex.point);
            }
        for (std::size_t i = 0; i < by_surface.size(); ++i) {
            if (by_surface[i].count == 0) continue;
            int const more = by_surface[i].count - 1;
            reading_.report.warn(reading_.surfaces[i].line,
                                 "terrain: a tangent break of " + by_surface[i].first +
                                     (more > 0 ? ", and " + std::to_string(more) + " more" : ""));
        }
    }

    struct Break {
        int piece = 0;
        double turn = 0;  // rad
    };
    std::optional<Break> tangent_break_at(Vertex const& vertex) const {
        constexpr std::size_t most_edges = 16;  // where more meet nobody means them to be smooth
        std::size_t const count = std::min(vertex.edges.size(), most_edges);
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t j = i + 1; j < count; ++j) {
                IncidentEdge const &a = vertex.edges[i], &b = vertex.edges[j];
                Vec2 const onwards = -b.direction;
                double const turn =
                    std::abs(std::atan2(geometry::cross(a.direction, onwards), geometry::dot(a.direction, onwards)));
                if (turn >= physics::joint_turn && turn < largest_break) return Break{std::max(a.piece, b.piece), turn};
            }
        return std::nullopt;
    }

    void tight_arcs() {
        double widest = 0;
        for (physics::Ball const& ball : scene_.balls) widest = std::max(widest, ball.radius);
        for (Surface const& surface : reading_.surfaces) {
            Arc tightest;
            tightest.radius = widest;
            for (Outline const& outline : outlines_of(surface))
                for (geometry::Curve const& curve : outline.curves)
                    if (auto const* arc = std::get_if<Arc>(&curve); arc && arc->radius < tightest.radius)
                        if (balls_meet_inside_of(*arc, outline)) tightest = *arc;
            if (tightest.radius < widest)
                reading_.report.warn(surface.line, "terrain: a concave arc of radius " + shown(tightest.radius) +
                                                       " m is tighter than a ball of radius " + shown(widest) + " m");
        }
    }

    // A closed outline is met from the side on which the player is; an open one from above.
    bool balls_meet_inside_of(Arc const& arc, Outline const& outline) const {
        double const middle = arc.from + arc.sweep / 2;
        Vec2 const outward(std::cos(middle), std::sin(middle));
        if (!outline.closed || scene_.balls.empty()) return outward.y() < 0;
        std::span<Outline const> const one(&outline, 1);
        Vec2 const probe = arc.centre + outward * (arc.radius * (1 - 1e-2));
        bool const concave_side_is_inside = winding_round(one, probe) != 0;
        bool const player_is_inside = winding_round(one, scene_.balls[level_.player].start.position) != 0;
        return concave_side_is_inside == player_is_inside;
    }

    void balls_inside() {
        std::vector<geometry::Box> centres;
        for (physics::Ball const& ball : scene_.balls) centres.push_back({ball.start.position, ball.start.position});
        geometry::BoxTree const tree(centres);
        for (Surface const& surface : reading_.surfaces) {
            auto const outlines = outlines_of(surface);
            std::vector<int> enclosed;
            tree.each_overlapping(box_of(outlines), [&](int ball) {
                if (winding_round(outlines, scene_.balls[ball].start.position) != 0) enclosed.push_back(ball);
            });
            if (!surface.filled && is_whole_world(outlines, enclosed)) continue;
            for (int const ball : enclosed)
                reading_.report.warn(reading_.ball_lines[ball],
                                     "ball: starts inside the terrain of line " + std::to_string(surface.line));
        }
    }

    // A painted inside looks solid. An outline without paint is a box or a cave if it holds whatever a ball should
    // meet.
    bool is_whole_world(std::span<Outline const> outlines, std::vector<int> const& enclosed) const {
        if (enclosed.size() < scene_.balls.size()) return false;
        for (std::size_t i = 0; i < reading_.sensor_lines.size(); ++i)
            if (level_.meanings[i] == Meaning::goal &&
                winding_round(outlines, middle_of(scene_.sensors[i].region)) == 0)
                return false;
        return true;
    }

    static Vec2 middle_of(physics::Region const& region) {
        if (auto const* disc = std::get_if<physics::DiscRegion>(&region)) return disc->centre;
        if (auto const* line = std::get_if<physics::LineRegion>(&region)) return (line->from + line->to) / 2;
        auto const& corners = std::get<physics::PolygonRegion>(region).corners;
        return (corners[0] + corners[corners.size() / 2]) / 2;
    }

    bool in_view(Vec2 const& point) const {
        return point.x() >= 0 && point.y() >= 0 && point.x() <= level_.size.x() && point.y() <= level_.size.y();
    }

    void out_of_view() {
        for (std::size_t i = 0; i < scene_.balls.size(); ++i)
            if (!in_view(scene_.balls[i].start.position))
                reading_.report.warn(reading_.ball_lines[i], "ball: starts outside the viewBox");
        for (std::size_t i = 0; i < reading_.sensor_lines.size(); ++i)
            if (!in_view(middle_of(scene_.sensors[i].region)))
                reading_.report.warn(reading_.sensor_lines[i],
                                     std::string(level_.meanings[i] == Meaning::goal ? "goal" : "banana") +
                                         ": lies outside the viewBox");
        geometry::Box const view{Vec2::Zero(), level_.size};
        for (Surface const& surface : reading_.surfaces)
            if (surface.outlines > 0 && !geometry::overlap(box_of(outlines_of(surface)), view))
                reading_.report.warn(surface.line, "terrain: lies outside the viewBox");
    }

    Reading& reading_;
    Level const& level_;
    physics::Scene const& scene_;
    Terrain const& terrain_;
};

}  // namespace

void add_suspicions(Reading& reading) { Check(reading).all(); }

}  // namespace level
