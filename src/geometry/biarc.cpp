#include "geometry/biarc.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "geometry/elementary.h"

namespace geometry {

namespace {

constexpr int most_halvings = 24;
constexpr int samples = 16;                 // points of the curve that must lie near its two arcs
constexpr double sampled_share = 0.9;       // of the tolerance, for what lies between the samples
constexpr double straight_ratio = 1e6;      // radius over chord; beyond it an arc's centre is too far to place its ends
constexpr double widest_radius = 1e6;       // m, of terrain; a flatter arc is taken as straight, and must be near so
constexpr double tiny_share = 1e-3;         // of the tolerance: a piece this short is not looked into
constexpr double rounding = 1e-12;          // of the curve's size: nearer than this is the same
constexpr double smallest_agreement = 0.5;  // cosine between tangents within one pair of arcs

bool same(Vec2 const& a, Vec2 const& b) { return a.x() == b.x() && a.y() == b.y(); }

struct Cubic {
    Vec2 c0, c1, c2, c3;  // by powers of t
    double size = 0;      // m

    Vec2 at(double t) const { return c0 + t * (c1 + t * (c2 + t * c3)); }

    // Where the rate vanishes (a cusp, a doubled control point) the next rate that does not gives the direction.
    Vec2 tangent(double t, double side) const {
        Vec2 const rates[3] = {c1 + t * (2 * c2 + t * 3 * c3), side * (2 * c2 + 6 * t * c3), c3};
        for (Vec2 const& rate : rates)
            if (double const speed = length(rate); speed > 1e-9 * size) return rate / speed;
        return {1, 0};
    }
};

// One with its centre in the origin and its axes along x and y, where both x and y / b are not negative: of its four
// quarters it is one, the others are its mirror images.
struct EllipseQuarter {
    double a = 0, b = 0;  // m, b may be negative

    Vec2 at(double t) const {
        SineCosine const turn = sine_cosine(t);
        return {a * turn.cosine, b * turn.sine};
    }
    Vec2 tangent(double t) const {
        SineCosine const turn = sine_cosine(t);
        Vec2 const rate(-a * turn.sine, b * turn.cosine);
        return rate / length(rate);
    }
};

// The arc that leaves `from` along the unit `tangent` and ends in `to`.
Curve tangent_arc(Vec2 const& from, Vec2 const& tangent, Vec2 const& to) {
    Vec2 const chord = to - from;
    double const across = cross(tangent, chord);
    double const reach = dot(chord, chord);
    if (std::abs(across) * 2 * straight_ratio <= std::sqrt(reach)) return Segment{from, to};
    double const signed_radius = reach / (2 * across);
    if (std::abs(signed_radius) > widest_radius) return Segment{from, to};
    Vec2 const outward = turned_right(tangent) * signed_radius;
    return Arc{from - outward, std::abs(signed_radius), arctangent(outward.y(), outward.x()),
               2 * arctangent(across, dot(tangent, chord))};
}

// Two arcs with a common tangent between; of the one-parameter family, the pair with equal control lengths.
std::vector<Curve> biarc(Vec2 const& p, Vec2 const& tangent_p, Vec2 const& q, Vec2 const& tangent_q) {
    Vec2 const chord = q - p;
    double const along = dot(chord, tangent_p + tangent_q);
    double const reach = dot(chord, chord);
    double const bend = 1 - dot(tangent_p, tangent_q);
    double const control = reach / (along + std::sqrt(along * along + 2 * bend * reach));
    Vec2 const joint = 0.5 * (p + q + control * (tangent_p - tangent_q));
    return {tangent_arc(p, tangent_p, joint), reversed(tangent_arc(q, -tangent_q, joint))};
}

// From the line or the whole circle that a curve is part of.
double distance_to_whole(Curve const& curve, Vec2 const& point) {
    if (auto const* arc = std::get_if<Arc>(&curve)) return std::abs(length(point - arc->centre) - arc->radius);
    auto const& segment = std::get<Segment>(curve);
    Vec2 const way = segment.end - segment.start;
    return std::abs(cross(way, point - segment.start)) / length(way);
}

// Whether the samples, in sixteenths, lie near the pair, each near the arc on its side of the joint. What fails does so
// early, in the middle or at a quarter.
template <typename Path>
bool stays_near(Path const& path, double low, double high, std::vector<Curve> const& pair, double tolerance,
                std::span<int const> order) {
    Vec2 const joint = end_of(pair[0]), chord = end_of(pair[1]) - start_of(pair[0]);
    for (int const i : order) {
        Vec2 const point = path.at(low + (high - low) * i / samples);
        Curve const& near = pair[dot(point - joint, chord) < 0 ? 0 : 1];
        if (!(distance_to_whole(near, point) <= tolerance)) return false;
    }
    return true;
}

// Whether the piece turns so little that a pair of arcs can follow it without a loop or a fold.
bool is_gentle(Cubic const& path, double low, double high) {
    Vec2 const chord = path.at(high) - path.at(low);
    Vec2 const start = path.tangent(low, 1);
    if (!(dot(chord, start) > 0 && dot(chord, path.tangent(high, -1)) > 0)) return false;
    for (int quarter = 1; quarter <= 4; ++quarter)
        if (dot(start, path.tangent(low + (high - low) * quarter / 4, -1)) < smallest_agreement) return false;
    return true;
}

// A straight step over a piece that is shorter than any curve shows; such steps in a row are one.
void add_tiny(Vec2 const& start, Vec2 const& end, double tiny, std::vector<Curve>& arcs) {
    if (same(start, end)) return;
    auto* before = arcs.empty() ? nullptr : std::get_if<Segment>(&arcs.back());
    if (before != nullptr && length(before->end - before->start) <= 2 * tiny)
        before->end = end;
    else
        arcs.push_back(Segment{start, end});
}

void add_arcs(Cubic const& path, double low, double high, double tolerance, int halvings, std::vector<Curve>& arcs) {
    constexpr int order[] = {4, 12, 8, 2, 6, 10, 14, 1, 3, 5, 7, 9, 11, 13, 15};
    Vec2 const start = path.at(low);
    Vec2 const end = path.at(high);
    double const middle = 0.5 * (low + high);
    double const tiny = tiny_share * tolerance;
    Vec2 const between = path.at(middle);
    bool const is_tiny = length(between - start) + length(end - between) <= tiny;
    if (is_tiny || halvings == most_halvings) return add_tiny(start, end, tiny, arcs);
    if (is_gentle(path, low, high)) {
        std::vector<Curve> const pair = biarc(start, path.tangent(low, 1), end, path.tangent(high, -1));
        if (stays_near(path, low, high, pair, sampled_share * tolerance, order)) {
            arcs.insert(arcs.end(), pair.begin(), pair.end());
            return;
        }
    }
    add_arcs(path, low, middle, tolerance, halvings + 1, arcs);
    add_arcs(path, middle, high, tolerance, halvings + 1, arcs);
}

// A point of an ellipse with what its pieces need to know there.
struct Station {
    double t = 0;
    Vec2 point = Vec2::Zero(), tangent = Vec2::Zero();
};

// A pair of arcs of length h leaves a curve whose curvature changes by k per metre by k h^3 / 324, farthest at a third
// and two thirds of h; the sixteenths beside these are seen first.
double foreseen_error(EllipseQuarter const& quarter, double middle, double chord) {
    SineCosine const turn = sine_cosine(middle);
    double const a = quarter.a, b = quarter.b;
    double const square = a * a * turn.sine * turn.sine + b * b * turn.cosine * turn.cosine;  // of the rate by t
    double const change = 3 * std::abs(a * b * (a * a - b * b) * turn.sine * turn.cosine) / (square * square * square);
    return change * chord * chord * chord / 324;
}

// A quarter has no inflection and turns one way by no more than a right angle, so that its ends tell how far.
void add_quarter(EllipseQuarter const& quarter, Station const& low, Station const& high, double tolerance, int halvings,
                 std::vector<Curve>& arcs) {
    constexpr int order[] = {5, 11, 6, 10, 3, 13, 8};
    constexpr double hopeless = 3;  // tolerances: more than the forecast is wrong by
    double const middle = 0.5 * (low.t + high.t);
    double const tiny = tiny_share * tolerance;
    double const chord = length(high.point - low.point);
    if (chord <= tiny || halvings == most_halvings) return add_tiny(low.point, high.point, tiny, arcs);
    bool const gentle = dot(low.tangent, high.tangent) >= smallest_agreement;
    if (gentle && foreseen_error(quarter, middle, chord) <= hopeless * tolerance) {
        std::vector<Curve> const pair = biarc(low.point, low.tangent, high.point, high.tangent);
        if (stays_near(quarter, low.t, high.t, pair, sampled_share * tolerance, order)) {
            arcs.insert(arcs.end(), pair.begin(), pair.end());
            return;
        }
    }
    Station const between{middle, quarter.at(middle), quarter.tangent(middle)};
    add_quarter(quarter, low, between, tolerance, halvings + 1, arcs);
    add_quarter(quarter, between, high, tolerance, halvings + 1, arcs);
}

std::vector<Curve> arcs_of_quarter(EllipseQuarter const& quarter, double low, double high, double tolerance) {
    std::vector<Curve> arcs;
    add_quarter(quarter, {low, quarter.at(low), quarter.tangent(low)}, {high, quarter.at(high), quarter.tangent(high)},
                tolerance, 0, arcs);
    return arcs;
}

void append(std::vector<Curve>& curves, std::vector<Curve> more, bool backwards) {
    if (backwards) {
        std::reverse(more.begin(), more.end());
        for (Curve& curve : more) curve = reversed(curve);
    }
    curves.insert(curves.end(), more.begin(), more.end());
}

// Where the axes of an ellipse stand in the world.
struct Axes {
    Vec2 centre = Vec2::Zero();
    Vec2 along = Vec2::Zero();  // unit
    double turned_by = 0;       // rad

    // From the frame of the axes, mirrored at one or both of them.
    Curve placed(Curve const& curve, bool mirror_x, bool mirror_y) const {
        auto const place = [&](Vec2 const& p) {
            return centre + turned(Vec2(mirror_x ? -p.x() : p.x(), mirror_y ? -p.y() : p.y()), along.x(), along.y());
        };
        if (auto const* segment = std::get_if<Segment>(&curve))
            return Segment{place(segment->start), place(segment->end)};
        auto const& arc = std::get<Arc>(curve);
        double const beyond_x = mirror_x ? pi - arc.from : arc.from;
        double const from = mirror_y ? -beyond_x : beyond_x;
        return Arc{place(arc.centre), arc.radius, turned_by + from, mirror_x == mirror_y ? arc.sweep : -arc.sweep};
    }
};

// centre + first cos t + second sin t from t on, cut where its axes cut it; each part is found in the first quarter.
std::vector<Curve> arcs_by_quarters(EllipticArc const& ellipse, double tolerance) {
    constexpr double right_angle = pi / 2;
    constexpr double same_angle = 1e-13;  // rad
    Vec2 const &first = ellipse.first, &second = ellipse.second;
    double const squares = dot(first, first) - dot(second, second), product = dot(first, second);
    double const phase = product == 0 ? 0 : 0.5 * arctangent(2 * product, squares);  // of the longer axis
    SineCosine const turn = sine_cosine(phase);
    Vec2 const axis = first * turn.cosine + second * turn.sine;
    double const a = length(axis);
    // Not from `second`: the other axis must be square to this, and keep the area.
    EllipseQuarter const quarter{a, cross(first, second) / a};
    Axes const axes{ellipse.centre, axis / a, arctangent(axis.y(), axis.x())};

    double const start = ellipse.from - phase, end = start + ellipse.sweep;
    double const low = std::min(start, end), high = std::max(start, end);
    std::vector<Curve> whole, arcs;
    int number = static_cast<int>(std::floor(low / right_angle + same_angle));
    for (double at = low; at < high - same_angle; ++number) {
        double const corner = number * right_angle, next = corner + right_angle;
        double const until = next > high - same_angle ? high : next;
        bool const is_odd = (number & 1) != 0;
        double const from = is_odd ? next - until : at - corner, to = is_odd ? next - at : until - corner;
        bool const is_whole = from < same_angle && to > right_angle - same_angle;
        if (is_whole && whole.empty()) whole = arcs_of_quarter(quarter, 0, right_angle, tolerance);
        std::vector<Curve> part = is_whole ? whole : arcs_of_quarter(quarter, from, to, tolerance);
        int const of_four = number & 3;
        for (Curve& curve : part) curve = axes.placed(curve, of_four == 1 || of_four == 2, of_four >= 2);
        append(arcs, std::move(part), is_odd);
        at = until;
    }
    std::vector<Curve> result;
    append(result, std::move(arcs), ellipse.sweep < 0);
    return result;
}

// The real roots of c0 + c1 t + c2 t^2 within (0, 1), in order.
std::vector<double> roots_within_one(double c0, double c1, double c2) {
    double const discriminant = c1 * c1 - 4 * c2 * c0;
    if (!(discriminant >= 0)) return {};
    double const q = -0.5 * (c1 + (c1 < 0 ? -std::sqrt(discriminant) : std::sqrt(discriminant)));
    std::vector<double> roots;
    for (double const root : {c0 / q, q / c2})
        if (root > 1e-9 && root < 1 - 1e-9) roots.push_back(root);
    std::sort(roots.begin(), roots.end());
    return roots;
}

// A curve on a straight line: out, and back where it overshoots.
std::vector<Curve> straight_pieces(Cubic const& cubic, Vec2 const& direction) {
    std::vector<double> ends =
        roots_within_one(dot(cubic.c1, direction), 2 * dot(cubic.c2, direction), 3 * dot(cubic.c3, direction));
    ends.push_back(1);
    std::vector<Curve> pieces;
    Vec2 start = cubic.c0;
    for (double const t : ends) {
        Vec2 const end = cubic.at(t);
        if (length(end - start) > rounding * cubic.size) pieces.push_back(Segment{start, end});
        start = end;
    }
    return pieces;
}

}  // namespace

std::vector<Curve> arcs_of_cubic(Vec2 const& p0, Vec2 const& p1, Vec2 const& p2, Vec2 const& p3, double tolerance) {
    Vec2 const legs[3] = {p1 - p0, p2 - p0, p3 - p0};
    Vec2 const longest =
        *std::max_element(legs, legs + 3, [](Vec2 const& a, Vec2 const& b) { return length(a) < length(b); });
    double const size = length(longest);
    if (!(size > 0)) return {};
    Cubic const cubic{p0, 3 * (p1 - p0), 3 * (p0 - 2 * p1 + p2), (p3 - p0) + 3 * (p1 - p2), size};
    auto const on_line = [&](Vec2 const& leg) { return std::abs(cross(longest, leg)) <= rounding * size * size; };
    if (std::all_of(legs, legs + 3, on_line)) return straight_pieces(cubic, longest / size);

    // Inflections and cusps: rate ^ bend = 0, a quadratic in t.
    std::vector<double> ends =
        roots_within_one(cross(cubic.c1, cubic.c2), 3 * cross(cubic.c1, cubic.c3), 3 * cross(cubic.c2, cubic.c3));
    std::vector<Curve> arcs;
    double start = 0;
    for (double const end : ends) {
        // A handle drawn in to its end has its double root there, and rounding moves it into the curve.
        double const nearest = std::min(length(cubic.at(end) - cubic.at(start)), length(p3 - cubic.at(end)));
        if (nearest <= tiny_share * tolerance) continue;
        add_arcs(cubic, start, end, tolerance, 0, arcs);
        start = end;
    }
    add_arcs(cubic, start, 1, tolerance, 0, arcs);
    return arcs;
}

std::vector<Curve> arcs_of_ellipse(EllipticArc const& ellipse, double tolerance) {
    Vec2 const& a = ellipse.first;
    Vec2 const& b = ellipse.second;
    double const size = std::max(length(a), length(b));
    if (!(size > 0) || ellipse.sweep == 0) return {};
    double const area = cross(a, b);
    std::vector<Curve> arcs;
    if (std::abs(dot(a, b)) <= rounding * size * size && std::abs(length(a) - length(b)) <= rounding * size) {
        double const turned_by = arctangent(a.y(), a.x());
        double const sense = area < 0 ? -1 : 1;
        arcs.push_back(Arc{ellipse.centre, size, turned_by + sense * ellipse.from, sense * ellipse.sweep});
        return arcs;
    }
    if (std::abs(area) <= rounding * size * size) {
        // Seen edge-on it runs there and back on a line; the steps miss the turning points by up to 1.2e-3 of its size.
        auto const at = [&](int step) {
            SineCosine const turn = sine_cosine(ellipse.from + ellipse.sweep * (step / 64.0));
            return ellipse.centre + ellipse.first * turn.cosine + ellipse.second * turn.sine;
        };
        for (int i = 0; i < 64; ++i) {
            Vec2 const start = at(i), end = at(i + 1);
            if (!same(start, end)) arcs.push_back(Segment{start, end});
        }
        return arcs;
    }
    return arcs_by_quarters(ellipse, tolerance);
}

}  // namespace geometry
