#include "physics/terrain/terrain_merge.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <unordered_map>

#include "geometry/elementary.h"

namespace physics {

using geometry::Arc;
using geometry::Curve;
using geometry::pi;
using geometry::Segment;

namespace {

bool comes_before(Vec2 const& a, Vec2 const& b) { return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y()); }

// The chains of points that lie within `vertex_reach` of each other, found in cells as wide as that. Points are sorted,
// and a chain is known by its first.
class Chains {
public:
    explicit Chains(std::vector<Vec2> points) : points_(std::move(points)) {
        std::sort(points_.begin(), points_.end(), comes_before);
        points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
        first_.resize(points_.size());
        std::iota(first_.begin(), first_.end(), 0);
        for (int i = 0; i < static_cast<int>(points_.size()); ++i) join_neighbours(i);
    }

    Vec2 const& place_of(Vec2 const& point) {
        auto const found = std::lower_bound(points_.begin(), points_.end(), point, comes_before);
        return points_[root(static_cast<int>(found - points_.begin()))];
    }

private:
    static std::uint64_t key(std::int64_t column, std::int64_t row) {
        return static_cast<std::uint64_t>(column) * 0x9E3779B97F4A7C15ULL + static_cast<std::uint64_t>(row);
    }
    int root(int i) {
        while (first_[i] != i) i = first_[i] = first_[first_[i]];
        return i;
    }
    void join_neighbours(int i) {
        Vec2 const& point = points_[i];
        auto const column = static_cast<std::int64_t>(std::floor(point.x() / vertex_reach));
        auto const row = static_cast<std::int64_t>(std::floor(point.y() / vertex_reach));
        for (std::int64_t c = column - 1; c <= column + 1; ++c)
            for (std::int64_t r = row - 1; r <= row + 1; ++r) {
                auto const cell = cells_.find(key(c, r));
                if (cell == cells_.end()) continue;
                for (int const j : cell->second)
                    if (geometry::length(points_[j] - point) <= vertex_reach) {
                        int const a = root(i), b = root(j);
                        first_[std::max(a, b)] = std::min(a, b);
                    }
            }
        cells_[key(column, row)].push_back(i);
    }

    std::vector<Vec2> points_;
    std::vector<int> first_;
    std::unordered_map<std::uint64_t, std::vector<int>> cells_;
};

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
    for (Piece const& piece : pieces)
        if (!geometry::is_whole_circle(piece.curve)) {
            ends.push_back(geometry::start_of(piece.curve));
            ends.push_back(geometry::end_of(piece.curve));
        }
    return ends;
}

std::vector<Piece> with_ends_joined(std::vector<Piece> const& drawn) {
    Chains chains(ends_of(drawn));
    std::vector<Piece> pieces;
    for (Piece const& piece : drawn) {
        // What has no length has neither a tangent nor a side to touch.
        if (!(geometry::length_of(piece.curve) > 0)) continue;
        if (geometry::is_whole_circle(piece.curve)) {
            pieces.push_back(piece);
            continue;
        }
        Vec2 const start = chains.place_of(geometry::start_of(piece.curve));
        Vec2 const end = chains.place_of(geometry::end_of(piece.curve));
        auto const* arc = std::get_if<Arc>(&piece.curve);
        if (start != end)
            append_moved(pieces, piece, start, end);
        else if (arc != nullptr && std::abs(arc->sweep) > pi)
            pieces.push_back({Arc{arc->centre, arc->radius, arc->from, std::copysign(2 * pi, arc->sweep)},
                              piece.material, piece.surface});
    }
    return pieces;
}

std::vector<Vec2> sorted_points(std::vector<Piece> const& pieces) {
    // Ends of arcs are worked out: what differs by rounding alone is one point.
    Chains chains(ends_of(pieces));
    std::vector<Vec2> points;
    for (Vec2 const& end : ends_of(pieces)) points.push_back(chains.place_of(end));
    std::sort(points.begin(), points.end(), comes_before);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return points;
}

// How far along a curve, in the sense of travel, a point next to it lies: rad on arcs, m on lines.
double place_along(Curve const& curve, Vec2 const& point) {
    if (auto const* segment = std::get_if<Segment>(&curve)) {
        Vec2 const way = segment->end - segment->start;
        return geometry::dot(point - segment->start, way) / geometry::length(way);
    }
    Arc const& arc = std::get<Arc>(curve);
    double const turn = std::copysign(1.0, arc.sweep) * (angle_of(point - arc.centre) - arc.from);
    return turn - 2 * pi * std::floor(turn / (2 * pi));
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

std::vector<Piece> parted_at_points(std::vector<Piece> const& whole) {
    std::vector<Curve> curves;
    curves.reserve(whole.size());
    for (Piece const& piece : whole) curves.push_back(piece.curve);
    geometry::BoxTree const tree{std::span<Curve const>(curves)};
    struct Place {
        double along;
        Vec2 point;
    };
    std::vector<std::vector<Place>> places(whole.size());
    for (Vec2 const& point : sorted_points(whole))
        tree.each_near(geometry::stroke_of(point, point, lies_on), [&](int i) {
            geometry::Nearest const nearest = geometry::nearest_point(curves[i], point);
            bool const at_an_end = !geometry::is_whole_circle(curves[i]) &&
                                   (geometry::length(geometry::start_of(curves[i]) - point) <= vertex_reach ||
                                    geometry::length(geometry::end_of(curves[i]) - point) <= vertex_reach);
            if (nearest.distance <= lies_on && nearest.inside && !at_an_end)
                places[i].push_back({place_along(curves[i], point), point});
        });
    std::vector<Piece> pieces;
    for (std::size_t i = 0; i < whole.size(); ++i) {
        if (places[i].empty()) {
            pieces.push_back(whole[i]);
            continue;
        }
        std::stable_sort(places[i].begin(), places[i].end(),
                         [](Place const& a, Place const& b) { return a.along < b.along; });
        std::vector<Vec2> stops;
        for (Place const& place : places[i]) stops.push_back(place.point);
        append_parted(pieces, whole[i], stops);
    }
    return pieces;
}

Vec2 middle_of(Curve const& curve) {
    if (auto const* segment = std::get_if<Segment>(&curve)) return 0.5 * (segment->start + segment->end);
    Arc const& arc = std::get<Arc>(curve);
    return geometry::start_of(Arc{arc.centre, arc.radius, arc.from + arc.sweep / 2, arc.sweep});
}

// Pieces between the same two points lie on each other where their middles do; whole circles by centre and radius.
bool lie_on_each_other(MergedPieces const& all, int i, int j) {
    Curve const &a = all.pieces[i].curve, &b = all.pieces[j].curve;
    if (all.start[i] >= 0) return geometry::length(middle_of(a) - middle_of(b)) <= lies_on;
    Arc const &p = std::get<Arc>(a), &q = std::get<Arc>(b);
    return geometry::length(p.centre - q.centre) <= lies_on && std::abs(p.radius - q.radius) <= lies_on;
}

// By pair of points, then in the order of the file; whole circles by centre, so that those that lie on each other are
// near.
std::vector<int> in_groups(MergedPieces const& all) {
    std::vector<int> order(all.pieces.size());
    std::iota(order.begin(), order.end(), 0);
    auto const ends = [&](int i) { return std::minmax(all.start[i], all.end[i]); };
    std::stable_sort(order.begin(), order.end(), [&](int i, int j) {
        auto const a = ends(i), b = ends(j);
        if (a != b) return a < b;
        return all.start[i] < 0 &&
               std::get<Arc>(all.pieces[i].curve).centre.x() < std::get<Arc>(all.pieces[j].curve).centre.x();
    });
    return order;
}

bool may_lie_on_each_other(MergedPieces const& all, int i, int j) {
    if (std::minmax(all.start[i], all.end[i]) != std::minmax(all.start[j], all.end[j])) return false;
    return all.start[i] >= 0 ||
           std::get<Arc>(all.pieces[j].curve).centre.x() - std::get<Arc>(all.pieces[i].curve).centre.x() <= lies_on;
}

MergedPieces drawn_once(MergedPieces all) {
    std::vector<int> const order = in_groups(all);
    std::vector<bool> gone(all.pieces.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (gone[order[i]]) continue;
        for (std::size_t j = i + 1; j < order.size() && may_lie_on_each_other(all, order[i], order[j]); ++j)
            if (!gone[order[j]] && lie_on_each_other(all, order[i], order[j])) {
                Piece& stays = all.pieces[order[i]];
                take_over(stays.material, all.pieces[order[j]].material);
                stays.surface = std::min(stays.surface, all.pieces[order[j]].surface);
                gone[order[j]] = true;
            }
    }
    MergedPieces once;
    once.points = std::move(all.points);
    for (std::size_t i = 0; i < gone.size(); ++i) {
        if (gone[i]) continue;
        once.pieces.push_back(all.pieces[i]);
        once.start.push_back(all.start[i]);
        once.end.push_back(all.end[i]);
    }
    return once;
}

int index_of(std::vector<Vec2> const& points, Vec2 const& place) {
    return static_cast<int>(std::lower_bound(points.begin(), points.end(), place, comes_before) - points.begin());
}

}  // namespace

MergedPieces merged(std::vector<Piece> drawn) {
    MergedPieces all;
    all.pieces = parted_at_points(with_ends_joined(drawn));
    all.points = sorted_points(all.pieces);
    Chains chains(ends_of(all.pieces));
    for (Piece const& piece : all.pieces) {
        bool const whole = geometry::is_whole_circle(piece.curve);
        all.start.push_back(whole ? -1 : index_of(all.points, chains.place_of(geometry::start_of(piece.curve))));
        all.end.push_back(whole ? -1 : index_of(all.points, chains.place_of(geometry::end_of(piece.curve))));
    }
    return drawn_once(std::move(all));
}

}  // namespace physics
