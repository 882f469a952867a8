// Sweeps along a circular track, and what a ball touches where it is.
#include <algorithm>
#include <cmath>

#include "geometry/elementary.h"
#include "physics/sweep.h"

namespace physics {

using geometry::Arc;
using geometry::dot;
using geometry::pi;
using geometry::Segment;

namespace {

// The ball's centre runs on a circle: its gap to a line or to another circle is a + b cos(phi - psi), which falls at
// one angle for each sense of running round.
class CircleSweep {
public:
    CircleSweep(Terrain const& terrain, Track const& circle, double q, int direction, double radius, double until,
                Skipped const& skipped)
        : terrain_(terrain),
          track_(circle),
          radius_(radius),
          skipped_(skipped),
          phi_(circle.phi0 - circle.sense * q / circle.rho),
          turn_(-direction * circle.sense) {
        first.time = until;
    }

    void meet_piece(int index) {
        if (!skipped_.has(index)) {
            if (auto const* segment = std::get_if<Segment>(&terrain_.pieces[index].curve))
                meet_segment(index, *segment);
            else
                meet_arc(index, std::get<Arc>(terrain_.pieces[index].curve));
        }
        meet_end(index, terrain_.start_vertex[index]);
        meet_end(index, terrain_.end_vertex[index]);
    }

    Obstacle first;
    bool found = false;

private:
    Vec2 centre_at(double phi) const {
        auto const [sine, cosine] = geometry::sine_cosine(phi);
        return track_.origin + track_.rho * Vec2(cosine, sine);
    }

    // offset + swing cos(phi - psi) falls through zero, on the way turn_, at the angle returned by the offer.
    template <typename Admits>
    void meet(double offset, double swing, double psi, Contact contact, Admits&& admits) {
        if (!(swing > std::abs(offset))) return;
        double const phi = psi + turn_ * geometry::arccosine(-offset / swing);
        double turn = turn_ * (phi - phi_);
        turn -= 2 * pi * std::floor(turn / (2 * pi));
        if (2 * pi - turn < touch_reach / track_.rho) turn = 0;
        double const way = turn * track_.rho;
        if (way > first.time || (found && way == first.time && contact.feature > first.contact.feature)) return;
        if (!admits(centre_at(phi))) return;
        first = {way, contact};
        found = true;
    }

    void meet_segment(int index, Segment const& segment) {
        Vec2 const way = segment.end - segment.start;
        double const span = geometry::length(way);
        Vec2 const along = way / span;
        for (int const side : {1, -1}) {
            Vec2 const normal = side * geometry::turned_left(along);
            double const offset = dot(track_.origin - segment.start, normal) - radius_;
            meet(offset, track_.rho, angle_of(normal), {index, side}, [&](Vec2 const& centre) {
                double const foot = dot(centre - segment.start, along);
                return foot >= -touch_reach && foot <= span + touch_reach;
            });
        }
    }

    void meet_arc(int index, Arc const& arc) {
        int const inner_side = arc.sweep > 0 ? 1 : -1;
        auto const admits = [&](Vec2 const& centre) { return spans_loosely(arc, centre - arc.centre); };
        meet_circle(arc.centre, arc.radius + radius_, 1, {index, -inner_side}, admits);
        if (fits(terrain_, {index, inner_side}, radius_))
            meet_circle(arc.centre, arc.radius - radius_, -1, {index, inner_side}, admits);
    }

    void meet_end(int index, int vertex) {
        if (vertex < 0 || terrain_.vertices[vertex].spokes.front().piece != index) return;
        int const feature = terrain_.feature_of_vertex(vertex);
        Vertex const& v = terrain_.vertices[vertex];
        if (v.cone_width == 0 || skipped_.has(feature)) return;
        meet_circle(v.point, radius_, 1, {feature, 1},
                    [&](Vec2 const& centre) { return exposes(v, (centre - v.point) / radius_); });
    }

    template <typename Admits>
    void meet_circle(Vec2 const& centre, double rho, int sense, Contact contact, Admits&& admits) {
        Vec2 const between = track_.origin - centre;
        double const d = geometry::length(between);
        if (d == 0) return;
        // D^2 - rho^2 = d^2 + track.rho^2 - rho^2 + 2 d track.rho cos(phi - psi); inside, its negative.
        double const offset = d * d + (track_.rho - rho) * (track_.rho + rho);
        double const psi = angle_of(between) + (sense > 0 ? 0 : pi);
        meet(sense * offset, 2 * d * track_.rho, psi, contact, admits);
    }

    Terrain const& terrain_;
    Track const& track_;
    double radius_;
    Skipped const& skipped_;
    double phi_;
    double turn_;  // the sense in which phi runs
};

// All that lies within `reach` of a stretch of a circular track: of its chord and, as it bulges, a little more.
geometry::Stroke stroke_along(Track const& circle, double q, int direction, double way, double reach) {
    double const turn = way / circle.rho;
    if (!(turn < pi)) return geometry::stroke_of(circle.origin, circle.origin, circle.rho + reach);
    double const bulge = circle.rho * (1 - geometry::sine_cosine(turn / 2).cosine);
    return geometry::stroke_of(position_at(circle, q), position_at(circle, q + direction * way), reach + bulge);
}

// Sides and normals of what is touched; joints offer the same normal twice.
void add_support(std::vector<Support>& supports, Contact contact, Vec2 const& normal) {
    for (Support const& s : supports)
        if (geometry::length(s.normal - normal) <= touch_reach) return;
    supports.push_back({contact, normal});
}

void add_segment_support(std::vector<Support>& supports, int index, Segment const& segment, Vec2 const& centre,
                         double radius) {
    Vec2 const way = segment.end - segment.start;
    double const span = geometry::length(way);
    Vec2 const along = way / span;
    double const foot = dot(centre - segment.start, along);
    if (foot < -touch_reach || foot > span + touch_reach) return;
    double const height = dot(centre - segment.start, geometry::turned_left(along));
    if (std::abs(std::abs(height) - radius) > touch_reach) return;
    int const side = height > 0 ? 1 : -1;
    add_support(supports, {index, side}, side * geometry::turned_left(along));
}

void add_arc_support(std::vector<Support>& supports, Terrain const& terrain, int index, Arc const& arc,
                     Vec2 const& centre, double radius) {
    Vec2 const out = centre - arc.centre;
    double const distance = geometry::length(out);
    if (distance == 0 || !spans_loosely(arc, out)) return;
    int const inner_side = arc.sweep > 0 ? 1 : -1;
    if (std::abs(distance - arc.radius - radius) <= touch_reach)
        add_support(supports, {index, -inner_side}, out / distance);
    else if (std::abs(arc.radius - radius - distance) <= touch_reach && fits(terrain, {index, inner_side}, radius))
        add_support(supports, {index, inner_side}, -out / distance);
}

void add_end_support(std::vector<Support>& supports, Terrain const& terrain, int index, int vertex, Vec2 const& centre,
                     double radius) {
    if (vertex < 0 || terrain.vertices[vertex].spokes.front().piece != index) return;
    Vec2 const out = centre - terrain.vertices[vertex].point;
    double const distance = geometry::length(out);
    if (std::abs(distance - radius) > touch_reach || !exposes(terrain.vertices[vertex], Vec2(out / distance))) return;
    add_support(supports, {terrain.feature_of_vertex(vertex), 1}, out / distance);
}

}  // namespace

Obstacle first_obstacle(Terrain const& terrain, Track const& circle, double q, int direction, double radius,
                        double until, Skipped const& skipped) {
    CircleSweep sweep(terrain, circle, q, direction, radius, until, skipped);
    geometry::Stroke const stroke = stroke_along(circle, q, direction, until, radius + touch_reach);
    terrain.tree.each_near(stroke, [&](int piece) { sweep.meet_piece(piece); });
    return sweep.found ? sweep.first : Obstacle{};
}

std::vector<Support> supports_at(Terrain const& terrain, Vec2 const& centre, double radius) {
    std::vector<Support> supports;
    terrain.tree.each_near(geometry::stroke_of(centre, centre, radius + touch_reach), [&](int piece) {
        if (auto const* segment = std::get_if<Segment>(&terrain.pieces[piece].curve))
            add_segment_support(supports, piece, *segment, centre, radius);
        else
            add_arc_support(supports, terrain, piece, std::get<Arc>(terrain.pieces[piece].curve), centre, radius);
        add_end_support(supports, terrain, piece, terrain.start_vertex[piece], centre, radius);
        add_end_support(supports, terrain, piece, terrain.end_vertex[piece], centre, radius);
    });
    return supports;
}

}  // namespace physics
