#include "view/bodies.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/box_tree.h"
#include "view/ground.h"

namespace view {

namespace {

constexpr double flatness = 0.0005;       // m: how far a chord may lie from its arc
constexpr double grass_spacing = 0.12;    // m
constexpr double ribbon_thickness = 0.3;  // m: the body of terrain that encloses nothing

// Between points of an edge, m: fine enough for grass, and coarser where a drawing has so much of it that nobody sees
// it grow.
double spacing_for(level::Level const& level) {
    constexpr double most_points = 200'000;
    double length = 0;
    for (level::Outline const& outline : level.outlines)
        for (geometry::Curve const& curve : outline.curves) length += geometry::length_of(curve);
    return std::max(grass_spacing, length / most_points);
}

void reverse_side(std::vector<Vec2>& left) {
    for (Vec2& v : left) v = -v;
}

std::vector<Vec2> actors_of(level::Level const& level) {
    std::vector<Vec2> actors;
    for (physics::Ball const& ball : level.scene.balls) actors.push_back(ball.start.position);
    for (std::size_t i = 0; i < level.scene.sensors.size(); ++i) {
        if (level.meanings[i] == level::Meaning::fall) continue;
        if (auto const* disc = std::get_if<physics::DiscRegion>(&level.scene.sensors[i].region))
            actors.push_back(disc->centre);
    }
    return actors;
}

double perimeter_of(Ring const& ring) {
    double sum = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) sum += geometry::length(ring[(i + 1) % ring.size()] - ring[i]);
    return sum;
}

// Terrain that encloses nothing, or encloses the play: a wall of even thickness beyond the edge.
Body wall_of(Ring edge, Closing closing, std::vector<Vec2> into) {
    Body body{std::move(edge), closing, std::move(into), {}, ribbon_thickness};
    body.rings = band_along(body.edge, body.into, closing, [](std::size_t) { return ribbon_thickness; });
    return body;
}

bool runs_one_way(Ring const& points) {
    double const way = points.back().x() - points.front().x();
    for (std::size_t i = 1; i < points.size(); ++i)
        if ((points[i].x() - points[i - 1].x()) * way < -1e-9) return false;
    return way != 0;
}

// The open outlines of a level, and what of the play may lie beneath one of them.
struct OpenOutlines {
    std::vector<Ring> edges;
    std::vector<Vec2> middles;  // a point of each edge
    std::vector<Vec2> actors;
};

bool has_beneath(Ring const& ring, OpenOutlines const& open, std::size_t own) {
    geometry::Box const box = box_of_ring(ring);
    auto const is_inside = [&](Vec2 const& point) {
        return geometry::overlap(box, {point, point}) && contains(ring, point);
    };
    if (std::any_of(open.actors.begin(), open.actors.end(), is_inside)) return true;
    for (std::size_t i = 0; i < open.middles.size(); ++i)
        if (i != own && is_inside(open.middles[i])) return true;
    return false;
}

// An open outline that crosses the level like a landscape, with nothing of the play beneath it, is filled below.
std::optional<Body> landscape_of(OpenOutlines const& open, std::size_t own, level::Level const& level) {
    Ring const& edge = open.edges[own];
    double const way = edge.back().x() - edge.front().x();
    if (!runs_one_way(edge) || std::abs(way) < 0.25 * level.size.x()) return std::nullopt;
    Body body{edge, Closing::open, left_of(edge, Closing::open), {}, 2};
    if (way > 0) reverse_side(body.into);
    geometry::Box const box = box_of_ring(edge);
    double const bottom = std::min(box.low.y(), 0.0) - std::max(level.size.y(), whole_height);
    Ring ring = edge;
    ring.push_back({edge.back().x(), bottom});
    ring.push_back({edge.front().x(), bottom});
    if (has_beneath(ring, open, own)) return std::nullopt;
    body.rings = {ring};
    return body;
}

Body open_body(OpenOutlines const& open, std::size_t own, level::Level const& level) {
    if (std::optional<Body> body = landscape_of(open, own, level)) return *body;
    // Balls roll on the upper side; beside an upright wall they are where most of the level is.
    Ring const& edge = open.edges[own];
    Vec2 const way = edge.back() - edge.front();
    std::vector<Vec2> into = left_of(edge, Closing::open);
    bool const upright = std::abs(way.x()) < 0.2 * std::abs(way.y());
    Vec2 const middle = (edge.back() + edge.front()) / 2;
    bool const play_left = upright ? geometry::cross(way, level.size / 2 - middle) > 0 : way.x() >= 0;
    if (play_left) reverse_side(into);
    return wall_of(edge, Closing::open, std::move(into));
}

std::vector<geometry::Box> boxes_of(std::vector<Ring> const& rings) {
    std::vector<geometry::Box> boxes;
    for (Ring const& ring : rings) boxes.push_back(box_of_ring(ring));
    return boxes;
}

// In the order of the file.
std::vector<std::size_t> overlapping(geometry::BoxTree const& tree, geometry::Box const& box) {
    std::vector<std::size_t> found;
    tree.each_overlapping(box, [&](int i) { found.push_back(static_cast<std::size_t>(i)); });
    std::sort(found.begin(), found.end());
    return found;
}

// Which closed outlines have the play inside: for every actor that an odd number of them surrounds, the outermost.
std::vector<bool> rooms_among(std::vector<Ring> const& rings, std::vector<Vec2> const& actors) {
    std::vector<bool> room(rings.size(), false);
    geometry::BoxTree const tree(boxes_of(rings));
    for (Vec2 const& actor : actors) {
        int around = 0;
        std::size_t outermost = 0;
        double largest = -1;
        for (std::size_t const i : overlapping(tree, {actor, actor})) {
            if (room[i] || !contains(rings[i], actor)) continue;
            ++around;
            double const area = std::abs(signed_area(rings[i]));
            if (area > largest) outermost = i, largest = area;
        }
        if (around % 2 == 1) room[outermost] = true;
    }
    return room;
}

Body solid_body(Ring const& ring) {
    Body body{ring, Closing::closed, left_of(ring, Closing::closed), {ring}, 1};
    double const area = signed_area(ring);
    if (area < 0) reverse_side(body.into);
    body.girth = 2 * std::abs(area) / std::max(perimeter_of(ring), 1e-9);
    return body;
}

// Solids and the holes in them: a ring inside an odd number of others bounds the earth around it.
void add_solids(std::vector<Body>& bodies, std::vector<Ring> const& rings, std::vector<bool> const& room) {
    std::vector<int> body_of(rings.size(), -1);
    geometry::BoxTree const tree(boxes_of(rings));
    auto const surrounders = [&](std::size_t i) {
        std::vector<std::size_t> around;
        for (std::size_t const j : overlapping(tree, {rings[i][0], rings[i][0]})) {
            if (j == i || room[j]) continue;
            bool const within = std::all_of(rings[i].begin(), rings[i].end(),
                                            [&](Vec2 const& point) { return contains(rings[j], point); });
            if (within) around.push_back(j);
        }
        return around;
    };
    std::vector<std::size_t> holes;
    for (std::size_t i = 0; i < rings.size(); ++i) {
        if (room[i]) continue;
        if (surrounders(i).size() % 2 == 1) {
            holes.push_back(i);
            continue;
        }
        body_of[i] = static_cast<int>(bodies.size());
        bodies.push_back(solid_body(rings[i]));
    }
    for (std::size_t hole : holes) {
        std::size_t parent = hole;
        double smallest = 1e300;
        for (std::size_t j : surrounders(hole)) {
            double const area = std::abs(signed_area(rings[j]));
            if (body_of[j] >= 0 && area < smallest) parent = j, smallest = area;
        }
        if (parent == hole) continue;
        bodies[static_cast<std::size_t>(body_of[parent])].rings.push_back(rings[hole]);
        Body edge = solid_body(rings[hole]);
        reverse_side(edge.into);
        edge.rings.clear();
        edge.girth = 1;
        bodies.push_back(std::move(edge));
    }
}

}  // namespace

std::vector<Body> bodies_of(level::Level const& level) {
    std::vector<Body> bodies;
    std::vector<Ring> closed;
    OpenOutlines open;
    double const spacing = spacing_for(level);
    for (level::Outline const& outline : level.outlines) {
        if (outline.painted) continue;
        Ring points = points_along(outline, spacing);
        if (points.size() < 2) continue;
        if (outline.closed && points.size() > 2)
            closed.push_back(std::move(points));
        else
            open.edges.push_back(std::move(points));
    }
    open.actors = actors_of(level);
    std::vector<bool> const room = rooms_among(closed, open.actors);
    for (std::size_t i = 0; i < closed.size(); ++i) {
        if (!room[i]) continue;
        std::vector<Vec2> into = left_of(closed[i], Closing::closed);
        if (signed_area(closed[i]) > 0) reverse_side(into);
        bodies.push_back(wall_of(closed[i], Closing::closed, std::move(into)));
    }
    for (Ring const& edge : open.edges) open.middles.push_back(edge[edge.size() / 2]);
    for (std::size_t i = 0; i < open.edges.size(); ++i) bodies.push_back(open_body(open, i, level));
    add_solids(bodies, closed, room);
    return bodies;
}

std::vector<Vec2> points_along(level::Outline const& outline, double spacing) {
    std::vector<Vec2> points;
    for (geometry::Curve const& curve : outline.curves) {
        double const length = geometry::length_of(curve);
        double chord = spacing;
        auto const* arc = std::get_if<geometry::Arc>(&curve);
        if (arc) chord = std::min(chord, std::sqrt(8 * flatness * std::max(arc->radius, flatness)));
        int const pieces = static_cast<int>(std::clamp(std::ceil(length / chord), 1.0, 20000.0));
        for (int i = 0; i < pieces; ++i) {
            double const share = static_cast<double>(i) / pieces;
            if (arc) {
                double const angle = arc->from + share * arc->sweep;
                points.push_back(arc->centre + arc->radius * Vec2(std::cos(angle), std::sin(angle)));
            } else {
                auto const& segment = std::get<geometry::Segment>(curve);
                points.push_back(segment.start + share * (segment.end - segment.start));
            }
        }
    }
    if (!outline.closed && !outline.curves.empty()) points.push_back(geometry::end_of(outline.curves.back()));
    return points;
}

}  // namespace view
