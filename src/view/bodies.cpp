#include "view/bodies.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "geometry/box_tree.h"
#include "view/camera.h"
#include "view/outline_points.h"

namespace view {

namespace {

constexpr double ribbon_thickness = 0.3;  // m: the body of terrain that encloses nothing

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

// The earth is on the inner side; whose it is the caller knows.
Body solid_edge(Ring ring) {
    double const area = signed_area(ring), perimeter = perimeter_of(ring);
    Body body{std::move(ring), Closing::closed, {}, {}, 1};
    body.into = left_of(body.edge, Closing::closed);
    if (area < 0) reverse_side(body.into);
    body.girth = 2 * std::abs(area) / std::max(perimeter, 1e-9);
    return body;
}

// Which rings lie in which: a ring inside an odd number of others is a hole.
class Nesting {
public:
    Nesting(std::vector<Ring> const& rings, std::vector<bool> const& room)
        : rings_(rings), boxes_(boxes_of(rings)), tree_(boxes_), places_(rings.size()), surrounds_(rings.size(), -1) {
        std::vector<std::size_t> order;
        for (std::size_t i = 0; i < rings.size(); ++i) {
            places_[i].area = std::abs(signed_area(rings[i]));
            if (!room[i]) order.push_back(i);
        }
        std::stable_sort(order.begin(), order.end(),
                         [&](std::size_t a, std::size_t b) { return places_[a].area > places_[b].area; });
        for (std::size_t at = 0; at < order.size(); ++at) {
            if (!place_in_one_of(std::span(order).subspan(at - std::min(at, recent), std::min(at, recent)), order[at]))
                place_among_all(order[at]);
        }
    }

    bool is_hole(std::size_t ring) const { return places_[ring].around % 2 == 1; }
    std::optional<std::size_t> solid_around(std::size_t ring) const { return places_[ring].solid; }

private:
    static constexpr std::size_t recent = 8;
    struct Place {
        double area = 0;                   // m^2
        int around = -1;                   // how many rings surround it; -1 = not known yet, or a room
        std::optional<std::size_t> solid;  // the smallest solid around it
        std::optional<std::size_t> outer;  // the smallest ring around it
    };

    bool is_within(std::size_t inner, std::size_t outer) const {
        geometry::Box const &a = boxes_[inner], &b = boxes_[outer];
        bool const fits = (a.low.array() >= b.low.array()).all() && (a.high.array() <= b.high.array()).all();
        return fits && std::all_of(rings_[inner].begin(), rings_[inner].end(),
                                   [&](Vec2 const& point) { return contains(rings_[outer], point); });
    }

    // Of rings in the order of their areas the smallest that surrounds this one tells what else does: so nests of many
    // rings are placed without asking all of them.
    bool place_in_one_of(std::span<std::size_t const> larger, std::size_t ring) {
        for (auto outer = larger.rbegin(); outer != larger.rend(); ++outer) {
            if (!is_within(ring, *outer)) continue;
            Place const& place = places_[*outer];
            places_[ring].around = place.around + 1;
            places_[ring].solid = is_hole(*outer) ? place.solid : *outer;
            places_[ring].outer = *outer;
            return true;
        }
        return false;
    }

    // From the smallest up: what surrounds a ring around this one need not be asked.
    void place_among_all(std::size_t ring) {
        std::vector<std::size_t> larger = overlapping(tree_, {rings_[ring][0], rings_[ring][0]});
        std::erase_if(larger, [&](std::size_t other) { return other == ring || places_[other].around < 0; });
        std::stable_sort(larger.begin(), larger.end(),
                         [&](std::size_t a, std::size_t b) { return places_[a].area < places_[b].area; });
        auto const mark = static_cast<int>(ring);
        Place& place = places_[ring];
        place.around = 0;
        for (std::size_t const other : larger) {
            if (surrounds_[other] != mark && !is_within(ring, other)) continue;
            ++place.around;
            if (!place.outer) place.outer = other;
            if (!place.solid && !is_hole(other)) place.solid = other;
            for (auto outer = std::optional(other); outer && surrounds_[*outer] != mark; outer = places_[*outer].outer)
                surrounds_[*outer] = mark;
        }
    }

    std::vector<Ring> const& rings_;
    std::vector<geometry::Box> boxes_;
    geometry::BoxTree tree_;
    std::vector<Place> places_;
    std::vector<int> surrounds_;  // by ring: around which other it is known to be, of those placed among all
};

// Solids and the holes in them, which bound the earth around them. Of the rings those of rooms are left.
void add_solids(std::vector<Body>& bodies, std::vector<Ring>& rings, std::vector<bool> const& room) {
    std::vector<std::size_t> body_of(rings.size());
    Nesting const nesting(rings, room);
    bodies.reserve(bodies.size() + rings.size());
    for (std::size_t i = 0; i < rings.size(); ++i) {
        if (room[i] || nesting.is_hole(i)) continue;
        body_of[i] = bodies.size();
        bodies.push_back(solid_edge(std::move(rings[i])));
        bodies.back().rings.push_back(bodies.back().edge);
    }
    for (std::size_t i = 0; i < rings.size(); ++i) {
        if (room[i] || !nesting.is_hole(i)) continue;
        auto const solid = nesting.solid_around(i);
        if (!solid) continue;
        bodies[body_of[*solid]].rings.push_back(rings[i]);
        Body edge = solid_edge(std::move(rings[i]));
        reverse_side(edge.into);
        edge.girth = 1;
        bodies.push_back(std::move(edge));
    }
}

}  // namespace

std::vector<Body> bodies_of(level::Level const& level) {
    std::vector<Body> bodies;
    std::vector<Ring> closed;
    OpenOutlines open;
    Fineness const fineness = fineness_for(level);
    for (level::Outline const& outline : level.outlines) {
        if (outline.painted) continue;
        Ring points = points_along(outline, fineness.spacing, fineness.flatness);
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

}  // namespace view
