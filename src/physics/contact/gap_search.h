// The search for the first closing gap between a ball on a path and the curves of the terrain. Gaps are polynomials of
// the path's parameter; a path says how lines and circles look from it.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/elementary.h"
#include "geometry/polynomial.h"
#include "physics/contact/first_contact.h"

namespace physics {

// `Path` has
//   to_line(normal, point, distance): (c(t) - point) . normal - distance, times a factor between 1 and 2
//   to_circle(centre, rho): |c(t) - centre|^2 - rho^2, times the same factor
//   at(t), speed(t), pull(t): the centre, and the sizes of its first and second derivatives
// and may have
//   later(t): the same path, counted from t on: where a gap is small its coefficients are without the rounding of far
//   away
// Coefficients stand lowest power first.
template <typename Path>
class GapSearch {
public:
    GapSearch(Terrain const& terrain, Path const& path, double radius, int own)
        : terrain_(terrain), path_(path), radius_(radius), own_(own) {}

    // `near` holds all that the ball can touch within `until`.
    void look_at(int index, geometry::Box const& near, double until) {
        if (index != own_) {
            if (auto const* segment = std::get_if<geometry::Segment>(&terrain_.pieces[index].curve))
                look_at_segment(index, *segment, until);
            else
                look_at_arc(index, std::get<geometry::Arc>(terrain_.pieces[index].curve), until);
        }
        look_at_end(index, terrain_.start_vertex[index], near, until);
        look_at_end(index, terrain_.end_vertex[index], near, until);
    }

    SweepHit first;

private:
    static constexpr int most_edges = 2;
    static constexpr int most_grazes = 4;  // of one gap, that a path comes to
    using Linear = decltype(std::declval<Path>().to_line(Vec2(), Vec2(), 0.0));

    // Where a ball has its nearest point on a feature between the feature's ends: where all edges are below
    // touch_reach, or, on arcs of more than half a turn, one of them.
    struct Domain {
        std::array<Linear, most_edges> edges;
        int count = 0;
        bool any = false;
        bool alone = false;  // nothing else is met beyond its edges

        void add(Linear const& edge) { edges[count++] = edge; }
        bool holds(double t) const {
            if (count == 0) return true;
            for (int i = 0; i < count; ++i) {
                bool const within = geometry::value_at(edges[i], t) <= touch_reach;
                if (within == any) return any;
            }
            return !any;
        }
    };

    void offer(double t, Contact contact) {
        if (t < first.time || (t == first.time && contact.feature < first.contact.feature)) first = {t, contact};
    }

    // Whether a gap that closes here opens again at once: its parabola does, and higher terms change that little.
    template <std::size_t N>
    bool grazes(std::array<double, N> const& gap, double metre, double t) const {
        if (!(gap[1] < 0 && gap[2] > 0)) return false;
        double const least = 2 * least_dip(path_.at(t)) * metre;
        double const bottom = gap[1] / (-2 * gap[2]), dip = dip_of(gap[1], 2 * gap[2]);
        auto const rise = [&](double share) { return geometry::value_at(gap, share * bottom) - gap[0]; };
        return dip - std::max(gap[0], 0.0) <= least && rise(1) >= -dip - least && rise(2) >= -least &&
               rise(4) >= 4 * dip;
    }

    // How a gap stands at the beginning of a stretch of the path.
    enum class Stand { open, met, opens };

    // Leaves the gap as the stretch should see it: closed gaps that open or stay are zero, and so are rates that are
    // rounding. `metre` is what a metre of the gap comes to.
    template <std::size_t N>
    Stand stand_at(std::array<double, N>& gap, double metre, double t, double bend) const {
        if (gap[0] > touch_reach * metre) return Stand::open;
        double const speed = path_.speed(t), pull = path_.pull(t);
        double const still = 2 * still_speed(path_.at(t), radius_, speed, pull) * metre;
        if (gap[1] < -still && !grazes(gap, metre, t)) return Stand::met;
        if (gap[0] < 0 && gap[0] >= -touch_reach * metre) gap[0] = 0;
        if (gap[1] > still) return Stand::opens;
        gap[1] = 0;
        double const straight = bend_rounding + place_rounding(path_.at(t), radius_);
        if (std::abs(gap[2]) <= straight * (pull + speed * speed * bend) * metre) gap[2] = 0;
        if (gap[2] < 0) return Stand::met;
        return Stand::opens;
    }

    // `bend` is the curvature of the gap's level lines, 1/m; `in_front(t)` whether the ball is on the contact's side.
    template <typename MakeGap, typename MakeDomain, typename InFront>
    void look(MakeGap const& gap_of, double metre, double bend, Contact contact, double until, MakeDomain&& make_domain,
              InFront&& in_front, double begin = 0) {
        auto const gap = gap_of(path_);
        until = std::min(until, first.time);
        if (begin > 0) {
            if (begin < until) look_through(make_domain(), gap, gap_of, metre, bend, contact, until, in_front, begin);
            return;
        }
        if (gap[0] > touch_reach * metre) {
            auto const fall = geometry::first_fall(gap, until);
            if (!fall) return;
            Domain const domain = make_domain();
            if (domain.holds(*fall) && !grazes(gap_from(*fall, gap, gap_of), metre, *fall))
                return offer(*fall, contact);
            look_through(domain, gap, gap_of, metre, bend, contact, until, in_front);
            return;
        }
        // A gap that is closed, but not by the ball where it is, must open before it can close.
        // Into a socket, whose gap never opens, the ball comes past the ends.
        bool const comes_up =
            is_to_socket(metre) || gap[0] >= -touch_reach * metre || in_front(0) || rises_to_touch(gap, metre, until);
        if (comes_up) look_through(make_domain(), gap, gap_of, metre, bend, contact, until, in_front);
    }

    static bool is_to_socket(double metre) { return metre < 4 * socket_play; }

    template <std::size_t N>
    static bool rises_to_touch(std::array<double, N> gap, double metre, double until) {
        for (double& c : gap) c = -c;
        gap[0] -= touch_reach * metre;
        return geometry::first_fall(gap, until).has_value();
    }

    // Where a gap that hardly opens closes again: rounding alone would tell where else it does, as where an arc is met
    // along its tangent at its end.
    template <std::size_t N>
    std::optional<double> top_of_least_rise(std::array<double, N> const& gap, double metre, double t) const {
        if (!(gap[1] > 0 && gap[2] < 0)) return std::nullopt;
        double const top = gap[1] / (-2 * gap[2]);
        double const least = is_to_socket(metre) ? touch_reach : 4 * least_dip(path_.at(t));
        if (gap[0] + 0.5 * top * gap[1] > least * metre) return std::nullopt;
        return top;
    }

    // When a gap that stands so at `from` first closes before `to` to stay closed.
    template <std::size_t N, typename MakeGap>
    std::optional<double> fall_within(std::array<double, N> from_here, std::array<double, N> const& gap,
                                      MakeGap const& gap_of, double metre, double bend, double from, double to) const {
        for (int graze = 0;; ++graze) {
            auto const fall = geometry::first_fall(from_here, to - from);
            if (!fall) return std::nullopt;
            from += *fall;
            std::array<double, N> const there = gap_from(from, gap, gap_of);
            if (graze == most_grazes || !grazes(there, metre, from)) return from;
            from -= there[1] / (2 * there[2]);
            if (!(from < to)) return std::nullopt;
            from_here = gap_from(from, gap, gap_of);
            if (stand_at(from_here, metre, from, bend) == Stand::met) return from;
        }
    }

    // Stretch by stretch of the path within the domain.
    template <std::size_t N, typename MakeGap>
    std::array<double, N> gap_from(double t, std::array<double, N> const& gap, MakeGap const& gap_of) const {
        if constexpr (requires { path_.later(t); })
            return t == 0 ? gap : gap_of(path_.later(t));
        else
            return geometry::counted_from(t, gap);
    }

    template <std::size_t N, typename MakeGap, typename InFront>
    void look_through(Domain const& domain, std::array<double, N> const& gap, MakeGap const& gap_of, double metre,
                      double bend, Contact contact, double until, InFront&& in_front, double begin = 0) {
        std::array<double, most_edges * geometry::most_coefficients + 2> bounds;
        int count = 0;
        bounds[count++] = begin;
        for (int i = 0; i < domain.count; ++i) {
            Linear edge = domain.edges[i];
            edge[0] -= touch_reach;
            geometry::Crossings const crossings = geometry::crossings(edge, until);
            for (double const t : crossings.all())
                if (t > begin) bounds[count++] = t;
        }
        std::sort(bounds.begin(), bounds.begin() + count);
        bounds[count++] = until;
        for (int i = 0; i + 1 < count; ++i) {
            double const from = bounds[i], to = bounds[i + 1];
            double const middle = to < never ? 0.5 * (from + to) : 2 * from + 1;
            if (!(to > from) && i > 0) continue;
            if (!domain.holds(middle)) continue;
            // Running off the feature's end: what comes next there, if anything does, is looked at by itself.
            Vec2 const place = path_.at(from);
            bool const goes_nowhere = geometry::length(path_.at(to < never ? to : middle) - place) <= 4 * touch_reach &&
                                      geometry::length(path_.at(middle) - place) <= 4 * touch_reach;
            if (to < until && goes_nowhere && !domain.alone) continue;
            if (!in_front(from)) continue;
            std::array<double, N> from_here = gap_from(from, gap, gap_of);
            Stand const stand = stand_at(from_here, metre, from, bend);
            // Past the end of the feature a gap within touch is as good as any other: it closes when it does.
            bool const comes_past = from > 0 && from_here[0] > 0;
            if (stand == Stand::met && !comes_past) return offer(from, contact);
            if (auto const top = top_of_least_rise(from_here, metre, from); from > 0 && top && *top < to - from)
                return offer(from + *top, contact);
            if (auto const fall = fall_within(from_here, gap, gap_of, metre, bend, from, to))
                return offer(*fall, contact);
        }
    }

    void look_at_segment(int index, geometry::Segment const& segment, double until) {
        Vec2 const way = segment.end - segment.start;
        double const span = geometry::length(way);
        Vec2 const along = way / span, left = geometry::turned_left(along);
        auto const make_domain = [&] {
            Domain domain;
            domain.add(path_.to_line(-along, segment.start, 0));
            domain.add(path_.to_line(along, segment.end, 0));
            return domain;
        };
        for (int const side : {1, -1}) {
            Vec2 const normal = side * left;
            look([&](Path const& path) { return path.to_line(normal, segment.start, radius_); }, 1, 0, {index, side},
                 until, make_domain, [&](double t) { return geometry::dot(path_.at(t) - segment.start, normal) > 0; });
        }
    }

    void look_at_arc(int index, geometry::Arc const& arc, double until) {
        int const inner_side = arc.sweep > 0 ? 1 : -1;
        auto const make_domain = [&] {
            Domain domain;
            if (terrain_.start_vertex[index] < 0) return domain;
            domain.any = std::abs(arc.sweep) > geometry::pi;
            domain.add(path_.to_line(-geometry::tangent_at_start(arc), arc.centre, 0));
            domain.add(path_.to_line(geometry::tangent_at_end(arc), arc.centre, 0));
            return domain;
        };
        auto const distance = [&](double t) { return geometry::length(path_.at(t) - arc.centre); };
        double const outer = arc.radius + radius_, inner = arc.radius - radius_;
        look([&](Path const& path) { return path.to_circle(arc.centre, outer); }, 2 * outer, 1 / outer,
             {index, -inner_side}, until, make_domain, [&](double t) { return distance(t) > arc.radius; });
        if (inner < -touch_reach) return;
        // On a track round its end a ball leaves a socket, or comes to it where the track ends.
        if (inner <= socket_play && ends_in_own(index)) return;
        double const rho = std::max(inner, 0.0);
        auto const gap_of = [&](Path const& path) {
            auto gap = path.to_circle(arc.centre, rho);
            for (double& c : gap) c = -c;
            return gap;
        };
        double const left = inner <= socket_play && distance(0) <= rho + socket_play
                                ? look_from_socket({index, inner_side}, arc, rho, until)
                                : 0;
        look(
            gap_of, 2 * rho + touch_reach, 1 / (rho + touch_reach), {index, inner_side}, until, make_domain,
            [&](double t) { return distance(t) < arc.radius; }, left);
    }

    bool ends_in_own(int index) const {
        auto const is_own = [&](int vertex) { return vertex >= 0 && terrain_.feature_of_vertex(vertex) == own_; };
        return is_own(terrain_.start_vertex[index]) || is_own(terrain_.end_vertex[index]);
    }

    // A ball in a socket closes on it where it moves towards one of its points; of those of less than half a turn it is
    // towards an end if towards any. The time when it has left.
    double look_from_socket(Contact contact, geometry::Arc const& arc, double rho, double until) {
        auto gap = path_.to_circle(arc.centre, rho + 4 * socket_play);
        for (double& c : gap) c = -c;
        double const left = geometry::first_fall(gap, until).value_or(until);
        int const parts = 1 + static_cast<int>(std::abs(arc.sweep) / (2 * geometry::pi / 3));
        for (int i = 0; i <= parts; ++i) {
            auto const [sine, cosine] = geometry::sine_cosine(arc.from + arc.sweep * i / parts);
            Vec2 const inward(-cosine, -sine);
            look([&](Path const& path) { return path.to_line(inward, arc.centre, 0); }, 1, 0, contact, left,
                 [] { return Domain{}; }, [](double) { return true; });
        }
        return left;
    }

    void look_at_end(int index, int vertex, geometry::Box const& near, double until) {
        if (vertex < 0 || terrain_.vertices[vertex].edges.front().piece != index) return;
        int const feature = terrain_.feature_of_vertex(vertex);
        Vertex const& v = terrain_.vertices[vertex];
        if (v.cone_width == 0 || feature == own_ || !overlap(near, {v.point, v.point})) return;
        if (is_beside_a_piece(v, near)) return;
        auto const make_domain = [&] {
            Domain domain;
            for (Vec2 const& direction : {v.first_edge, v.last_edge}) domain.add(path_.to_line(direction, v.point, 0));
            domain.alone = ends_narrow_arc(v);
            return domain;
        };
        look([&](Path const& path) { return path.to_circle(v.point, radius_); }, 2 * radius_, 1 / radius_, {feature, 1},
             until, make_domain, [](double) { return true; });
    }

    // Whether an arc hardly narrower than the ball ends here, which that does not touch inside.
    bool ends_narrow_arc(Vertex const& v) const {
        return std::any_of(v.edges.begin(), v.edges.end(), [&](IncidentEdge const& edge) {
            auto const* arc = std::get_if<geometry::Arc>(&terrain_.pieces[edge.piece].curve);
            double const room = arc == nullptr ? 0 : arc->radius - radius_;
            return room < -touch_reach && room > -socket_play;
        });
    }

    // Whether all of the way, and a moment beyond, lies beside one of the vertex's pieces: then the vertex is not
    // exposed to it.
    bool is_beside_a_piece(Vertex const& v, geometry::Box const& near) const {
        Vec2 const margin = Vec2::Constant(radius_ + touch_reach);
        Vec2 const low = near.low + margin - v.point, high = near.high - margin - v.point;
        return std::any_of(v.edges.begin(), v.edges.end(), [&](IncidentEdge const& edge) {
            Vec2 const& d = edge.direction;
            return geometry::dot({d.x() > 0 ? low.x() : high.x(), d.y() > 0 ? low.y() : high.y()}, d) > 8 * touch_reach;
        });
    }

    Terrain const& terrain_;
    Path const& path_;
    double radius_;
    int own_;
};

}  // namespace physics
