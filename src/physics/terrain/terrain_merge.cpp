#include "physics/terrain/terrain_merge.h"

#include <algorithm>

#include "geometry/elementary.h"
#include "physics/terrain/doubles.h"
#include "physics/terrain/places.h"

namespace physics {

using geometry::Arc;
using geometry::Curve;
using geometry::pi;
using geometry::Segment;

namespace {

// The arc between two other ends: what joined the old ones, turned and stretched.
Arc stretched(Arc const& arc, Vec2 const& start, Vec2 const& end) {
    Vec2 const from = geometry::start_of(arc), was = geometry::end_of(arc) - from, is = end - start;
    double const scale = 1 / geometry::dot(was, was);
    double const cosine = geometry::dot(was, is) * scale, sine = geometry::cross(was, is) * scale;
    Vec2 const centre = start + geometry::turned(Vec2(arc.centre - from), cosine, sine);
    return {centre, geometry::length(start - centre), angle_of(start - centre), arc.sweep};
}

// The same curve between ends that lie next to its own. Arcs of more than half a turn, whose ends may lie near each
// other, are moved in halves.
void append_moved(std::vector<Piece>& pieces, Piece const& piece, Vec2 const& start, Vec2 const& end) {
    bool const stays = geometry::start_of(piece.curve) == start && geometry::end_of(piece.curve) == end;
    auto const* arc = std::get_if<Arc>(&piece.curve);
    if (stays || arc == nullptr) {
        pieces.push_back(piece);
        if (!stays) pieces.back().curve = Segment{start, end};
        return;
    }
    if (std::abs(arc->sweep) <= pi) {
        pieces.push_back({stretched(*arc, start, end), piece.material, piece.surface});
        return;
    }
    Arc first = *arc, second = *arc;
    first.sweep = second.sweep = arc->sweep / 2;
    second.from += first.sweep;
    Vec2 const middle = geometry::start_of(second);
    pieces.push_back({stretched(first, start, middle), piece.material, piece.surface});
    pieces.push_back({stretched(second, middle, end), piece.material, piece.surface});
}

std::vector<Vec2> ends_of(std::vector<Piece> const& pieces) {
    std::vector<Vec2> ends;
    ends.reserve(2 * pieces.size());
    for (Piece const& piece : pieces)
        if (!geometry::is_whole_circle(piece.curve)) {
            ends.push_back(geometry::start_of(piece.curve));
            ends.push_back(geometry::end_of(piece.curve));
        }
    return ends;
}

// Pieces, and where the ends of those that are no whole circles are, in their order.
struct Joined {
    std::vector<Piece> pieces;
    Places places;
};

// Whether every end is drawn at its place already, and every piece has a length.
bool are_joined(std::vector<Piece> const& pieces, std::vector<Vec2> const& ends, Places const& places) {
    for (std::size_t i = 0; i < ends.size(); ++i)
        if (ends[i] != places.points[places.of_end[i]]) return false;
    for (std::size_t i = 0; i + 1 < ends.size(); i += 2)
        if (places.of_end[i] == places.of_end[i + 1]) return false;
    return std::all_of(pieces.begin(), pieces.end(),
                       [](Piece const& piece) { return geometry::length_of(piece.curve) > 0; });
}

Joined with_ends_joined(std::vector<Piece> drawn) {
    std::vector<Vec2> const ends = ends_of(drawn);
    Places places = places_of(ends);
    if (are_joined(drawn, ends, places)) return {std::move(drawn), std::move(places)};
    std::vector<Piece> pieces;
    pieces.reserve(drawn.size());
    std::size_t next_end = 0;
    for (Piece const& piece : drawn) {
        bool const whole = geometry::is_whole_circle(piece.curve);
        std::size_t const first_end = next_end;
        if (!whole) next_end += 2;
        // What has no length has neither a tangent nor a side to touch.
        if (!(geometry::length_of(piece.curve) > 0)) continue;
        if (whole) {
            pieces.push_back(piece);
            continue;
        }
        Vec2 const& start = places.points[places.of_end[first_end]];
        Vec2 const& end = places.points[places.of_end[first_end + 1]];
        auto const* arc = std::get_if<Arc>(&piece.curve);
        if (start != end)
            append_moved(pieces, piece, start, end);
        else if (arc != nullptr && std::abs(arc->sweep) > pi)
            pieces.push_back({Arc{arc->centre, arc->radius, arc->from, std::copysign(2 * pi, arc->sweep)},
                              piece.material, piece.surface});
    }
    // Ends of arcs are worked out: what differs by rounding alone is one point.
    places = places_of(ends_of(pieces));
    return {std::move(pieces), std::move(places)};
}

// How far along a curve, in the sense of travel, a point next to it lies: rad on arcs, m on lines.
double place_along(Curve const& curve, Vec2 const& point) {
    if (auto const* segment = std::get_if<Segment>(&curve)) {
        Vec2 const way = segment->end - segment->start;
        return geometry::dot(point - segment->start, way) / geometry::length(way);
    }
    Arc const& arc = std::get<Arc>(curve);
    return geometry::within_turn(std::copysign(1.0, arc.sweep) * (angle_of(point - arc.centre) - arc.from));
}

void append_parted(std::vector<Piece>& pieces, Piece const& piece, std::vector<Vec2> const& places) {
    auto const* arc = std::get_if<Arc>(&piece.curve);
    bool const whole = geometry::is_whole_circle(piece.curve);
    std::vector<Vec2> stops = places;
    // A circle that is parted once is parted on its other side as well, so that no piece ends where it begins.
    if (whole && stops.size() == 1) stops.push_back(2 * arc->centre - stops.front());
    if (whole) {
        stops.push_back(stops.front());
    } else {
        stops.insert(stops.begin(), geometry::start_of(piece.curve));
        stops.push_back(geometry::end_of(piece.curve));
    }
    for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
        Piece part = piece;
        if (arc != nullptr) {
            double const from = i == 0 && !whole ? 0 : place_along(piece.curve, stops[i]);
            double to = i + 2 == stops.size() && !whole ? std::abs(arc->sweep) : place_along(piece.curve, stops[i + 1]);
            if (to <= from) to += 2 * pi;
            double const sense = std::copysign(1.0, arc->sweep);
            part.curve = Arc{arc->centre, arc->radius, arc->from + sense * from, sense * (to - from)};
        }
        append_moved(pieces, part, stops[i], stops[i + 1]);
    }
}

// By piece: the points that lie on it between its ends, in the sense of travel.
std::vector<std::vector<Vec2>> points_within(std::vector<Piece> const& whole, geometry::BoxTree const& tree,
                                             std::vector<Vec2> const& points) {
    struct Place {
        int piece;
        double along;
        Vec2 point;
    };
    std::vector<Place> places;
    for (Vec2 const& point : points)
        tree.each_near(geometry::stroke_of(point, point, lies_on), [&](int i) {
            Curve const& curve = whole[i].curve;
            geometry::Nearest const nearest = geometry::nearest_point(curve, point);
            if (!nearest.inside || nearest.distance > lies_on) return;
            bool const at_an_end = !geometry::is_whole_circle(curve) &&
                                   (geometry::length(geometry::start_of(curve) - point) <= vertex_reach ||
                                    geometry::length(geometry::end_of(curve) - point) <= vertex_reach);
            if (!at_an_end) places.push_back({i, place_along(curve, point), point});
        });
    std::stable_sort(places.begin(), places.end(), [](Place const& a, Place const& b) {
        return a.piece < b.piece || (a.piece == b.piece && a.along < b.along);
    });
    std::vector<std::vector<Vec2>> within(places.empty() ? 0 : whole.size());
    for (Place const& place : places) within[place.piece].push_back(place.point);
    return within;
}

std::vector<Piece> parted_at(std::vector<Piece> const& whole, std::vector<std::vector<Vec2>> const& within) {
    std::vector<Piece> pieces;
    pieces.reserve(whole.size());
    for (std::size_t i = 0; i < whole.size(); ++i) {
        if (within[i].empty())
            pieces.push_back(whole[i]);
        else
            append_parted(pieces, whole[i], within[i]);
    }
    return pieces;
}

geometry::BoxTree tree_of(std::vector<Piece> const& pieces) {
    std::vector<Curve> curves;
    curves.reserve(pieces.size());
    for (Piece const& piece : pieces) curves.push_back(piece.curve);
    return geometry::BoxTree(std::span<Curve const>(curves));
}

}  // namespace

MergedPieces merged(std::vector<Piece> drawn) {
    Joined joined = with_ends_joined(std::move(drawn));
    MergedPieces all;
    all.tree = tree_of(joined.pieces);
    std::vector<std::vector<Vec2>> const within = points_within(joined.pieces, all.tree, joined.places.points);
    if (!within.empty()) {
        joined.pieces = parted_at(joined.pieces, within);
        joined.places = places_of(ends_of(joined.pieces));
    }
    all.pieces = std::move(joined.pieces);
    all.points = std::move(joined.places.points);
    std::vector<int> const& place_of_end = joined.places.of_end;
    std::size_t next_end = 0;
    all.start.reserve(all.pieces.size());
    all.end.reserve(all.pieces.size());
    for (Piece const& piece : all.pieces) {
        bool const whole = geometry::is_whole_circle(piece.curve);
        all.start.push_back(whole ? -1 : place_of_end[next_end++]);
        all.end.push_back(whole ? -1 : place_of_end[next_end++]);
    }
    if (leave_out_doubles(all) || !within.empty()) all.tree = tree_of(all.pieces);
    return all;
}

}  // namespace physics
