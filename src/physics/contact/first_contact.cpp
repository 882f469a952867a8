#include "physics/contact/first_contact.h"

#include "physics/contact/gap_search.h"

namespace physics {

using geometry::Box;
using geometry::dot;

namespace {

struct FreePath {
    Parabola start;

    std::array<double, 3> to_line(Vec2 const& normal, Vec2 const& point, double distance) const {
        return {dot(start.position - point, normal) - distance, dot(start.velocity, normal),
                0.5 * dot(start.acceleration, normal)};
    }
    std::array<double, 5> to_circle(Vec2 const& centre, double rho) const {
        return geometry::distance_quartic(start.position - centre, start.velocity, start.acceleration, rho);
    }
    Vec2 at(double t) const { return start.position + t * (start.velocity + (0.5 * t) * start.acceleration); }
    double speed(double t) const { return geometry::length(start.velocity + t * start.acceleration); }
    double pull(double) const { return geometry::length(start.acceleration); }
    FreePath later(double t) const { return {{at(t), start.velocity + t * start.acceleration, start.acceleration}}; }
};

Box box_of_path(FreePath const& path, double from, double to) {
    Box box;
    auto const include = [&](double t) {
        Vec2 const p = path.at(t);
        box.low = box.low.cwiseMin(p);
        box.high = box.high.cwiseMax(p);
    };
    include(from);
    include(to);
    for (int axis = 0; axis < 2; ++axis) {
        if (path.start.acceleration[axis] == 0) continue;
        double const turn = -path.start.velocity[axis] / path.start.acceleration[axis];
        if (turn > from && turn < to) include(turn);
    }
    return box;
}

// Out of the terrain's bounds for good: beyond one of them, going away and drawn away.
bool gone(Terrain const& terrain, FreePath const& path, double t, double radius) {
    Vec2 const position = path.at(t), velocity = path.start.velocity + t * path.start.acceleration;
    for (int axis = 0; axis < 2; ++axis) {
        double const v = velocity[axis], a = path.start.acceleration[axis];
        if (position[axis] > terrain.bounds.high[axis] + 2 * radius && v >= 0 && a >= 0) return true;
        if (position[axis] < terrain.bounds.low[axis] - 2 * radius && v <= 0 && a <= 0) return true;
    }
    return false;
}

// Radii of way in the first look, and by how much each later one is longer. In flight along a chain of short chords the
// next one is met soon, and what lies farther ahead need not be seen; on a track there is hardly ever anything to meet,
// and of few pieces none is in the way of the others.
constexpr double first_window = 1.0 / 16;
constexpr double first_window_in_the_open = 4;
constexpr double window_growth = 8;
constexpr std::size_t few_pieces = 16;

// The time in which a path covers about `way`.
double time_for(FreePath const& path, double t, double way) {
    double const speed = path.speed(t), a = path.pull(t);
    double const denominator = speed + std::sqrt(speed * speed + 2 * a * way);
    return denominator > 0 ? 2 * way / denominator : never;
}

}  // namespace

SweepHit first_contact(Terrain const& terrain, Parabola const& start, double radius, double until, int own,
                       double enough) {
    FreePath const path{start};
    GapSearch<FreePath> search(terrain, path, radius, own);
    if (terrain.pieces.empty()) return search.first;
    double from = 0;
    bool const in_the_open = until < never || terrain.pieces.size() <= few_pieces;
    double way = (in_the_open ? first_window_in_the_open : first_window) * radius;
    while (from < until && from <= enough) {
        if (gone(terrain, path, from, radius)) break;
        double const to = std::min(until, from + time_for(path, from, way));
        if (to == never || !(to > from)) break;
        Box const near = grown(box_of_path(path, from, to), radius + touch_reach);
        // A parabola is nowhere farther from its chord than this.
        double const sagitta = path.pull(from) * (to - from) * (to - from) / 8;
        geometry::Stroke const stroke{path.at(from), path.at(to), radius + touch_reach + sagitta, near};
        terrain.tree.each_near(stroke, [&](int piece) { search.look_at(piece, near, to); });
        if (search.first.time <= to) return search.first;
        from = to;
        way *= window_growth;
    }
    return search.first;
}

namespace {

// A circle, by u = tan(half the angle run through): its points are (1 - u^2, 2 u) / (1 + u^2), so that gaps to lines
// and to circles alike are quadratics over 1 + u^2. Used for a quarter turn at most, u <= 1.
struct RoundPath {
    Vec2 centre = Vec2::Zero();
    Vec2 out = Vec2::Zero();    // m, from the centre to the beginning
    Vec2 ahead = Vec2::Zero();  // m, as far, in the direction of the motion

    std::array<double, 3> to_line(Vec2 const& normal, Vec2 const& point, double distance) const {
        Vec2 const from_point = centre - point;
        return {dot(from_point + out, normal) - distance, 2 * dot(ahead, normal),
                dot(from_point - out, normal) - distance};
    }
    std::array<double, 3> to_circle(Vec2 const& other, double rho) const {
        Vec2 const between = centre - other;
        double const here = geometry::length(between + out), opposite = geometry::length(between - out);
        return {(here - rho) * (here + rho), 4 * dot(between, ahead), (opposite - rho) * (opposite + rho)};
    }
    Vec2 at(double u) const { return centre + ((1 - u * u) * out + (2 * u) * ahead) / (1 + u * u); }
    double speed(double) const { return 2 * geometry::length(out); }
    double pull(double) const { return 4 * geometry::length(out); }
};

constexpr double quarter = geometry::pi / 2;

// From phi on, `turn` radians.
SweepHit first_contact_on(Terrain const& terrain, RoundPath const& path, double turn, double radius, int own) {
    GapSearch<RoundPath> search(terrain, path, radius, own);
    auto const [sine, cosine] = geometry::sine_cosine(turn / 2);
    double const until = sine / cosine;
    double const bulge = geometry::length(path.out) * (1 - cosine);
    geometry::Stroke const stroke = geometry::stroke_of(path.at(0), path.at(until), radius + touch_reach + bulge);
    terrain.tree.each_near(stroke, [&](int piece) { search.look_at(piece, stroke.box, until); });
    return search.first;
}

}  // namespace

SweepHit first_contact(Terrain const& terrain, Track const& circle, double q, int direction, double radius,
                       double until, int own, double enough) {
    double const sense = -direction * circle.sense;
    double const phi = circle.phi0 - circle.sense * q / circle.rho;
    for (double way = 0; way <= until && way <= enough; way += quarter * circle.rho) {
        double const turn = std::min(quarter, (until - way) / circle.rho);
        auto const [sine, cosine] = geometry::sine_cosine(phi + sense * way / circle.rho);
        Vec2 const out = circle.rho * Vec2(cosine, sine);
        RoundPath const path{circle.origin, out, sense * geometry::turned_left(out)};
        SweepHit const found = first_contact_on(terrain, path, turn, radius, own);
        if (found.time < never) return {way + 2 * geometry::arctangent(found.time, 1) * circle.rho, found.contact};
        if (turn < quarter) break;
    }
    return {};
}

}  // namespace physics
