#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "geometry/biarc.h"

using namespace geometry;

namespace {

constexpr double pi_half = 1.57079632679489661923;
constexpr double joint_gap = 1e-9;  // m, the ends of an arc of a million chords' radius are rounded this much

double distance_to(std::vector<Curve> const& curves, Vec2 const& point) {
    double least = 1e300;
    for (Curve const& curve : curves) least = std::min(least, nearest_point(curve, point).distance);
    return least;
}

Vec2 point_of(Curve const& curve, double share) {
    if (auto const* s = std::get_if<Segment>(&curve)) return s->start + share * (s->end - s->start);
    Arc const& arc = std::get<Arc>(curve);
    double const angle = arc.from + share * arc.sweep;
    return arc.centre + arc.radius * Vec2(std::cos(angle), std::sin(angle));
}

// The larger of both one-sided distances, from dense samples of both.
double deviation(std::vector<Curve> const& curves, std::function<Vec2(double)> const& at) {
    constexpr int count = 1000;
    double worst = 0;
    std::vector<Vec2> points;
    for (int i = 0; i <= count; ++i) {
        points.push_back(at(static_cast<double>(i) / count));
        worst = std::max(worst, distance_to(curves, points.back()));
    }
    for (Curve const& curve : curves)
        for (double share = 0; share <= 1; share += 0.25) {
            double least = 1e300;
            for (int i = 0; i < count; ++i)
                least =
                    std::min(least, nearest_point(Segment{points[i], points[i + 1]}, point_of(curve, share)).distance);
            worst = std::max(worst, least);
        }
    return worst;
}

double widest_gap(std::vector<Curve> const& curves) {
    double gap = 0;
    for (std::size_t i = 1; i < curves.size(); ++i)
        gap = std::max(gap, length(start_of(curves[i]) - end_of(curves[i - 1])));
    return gap;
}

double sharpest_joint(std::vector<Curve> const& curves) {
    double kink = 0;
    for (std::size_t i = 1; i < curves.size(); ++i)
        kink = std::max(kink, length(tangent_at_start(curves[i]) - tangent_at_end(curves[i - 1])));
    return kink;
}

std::function<Vec2(double)> cubic(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    return [=](double t) -> Vec2 {
        double const s = 1 - t;
        return s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d;
    };
}

}  // namespace

TEST_CASE("arcs keep within a millimetre of any cubic and join with equal tangents") {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> metres(-5, 5);
    for (int i = 0; i < 40; ++i) {
        Vec2 p[4];
        for (Vec2& point : p) point = Vec2(metres(random), metres(random));
        std::vector<Curve> const arcs = arcs_of_cubic(p[0], p[1], p[2], p[3]);
        // The polyline of 1000 chords that stands for the curve is itself 1e-5 m off.
        CHECK(deviation(arcs, cubic(p[0], p[1], p[2], p[3])) <= drawing_tolerance + 2e-5);
        CHECK(widest_gap(arcs) <= joint_gap);
        CHECK(sharpest_joint(arcs) <= 3e-6);
        CHECK(length(start_of(arcs.front()) - p[0]) <= joint_gap);
        CHECK(length(end_of(arcs.back()) - p[3]) <= joint_gap);
        CHECK(arcs.size() < 150);
    }
}

TEST_CASE("cusps, loops, doubled control points and closed curves are followed") {
    Vec2 const shapes[][4] = {
        {{0, 0}, {2, 2}, {0, 2}, {2, 0}},   // a cusp
        {{0, 0}, {3, 2}, {-1, 2}, {2, 0}},  // a loop
        {{0, 0}, {0, 0}, {2, 2}, {4, 0}},  {{0, 0}, {2, 2}, {4, 0}, {4, 0}},  {{0, 0}, {0, 0}, {4, 1}, {4, 1}},
        {{0, 0}, {4, 0}, {0, 4}, {0, 0}},  {{0, 0}, {1, 1}, {3, -1}, {4, 0}},
    };
    for (auto const& p : shapes) {
        std::vector<Curve> const arcs = arcs_of_cubic(p[0], p[1], p[2], p[3]);
        CHECK(deviation(arcs, cubic(p[0], p[1], p[2], p[3])) <= drawing_tolerance + 2e-5);
        CHECK(widest_gap(arcs) <= joint_gap);
    }
}

TEST_CASE("a straight cubic is a segment, a point is nothing") {
    std::vector<Curve> const line = arcs_of_cubic({0, 0}, {1, 1}, {2, 2}, {3, 3});
    REQUIRE(line.size() == 1);
    CHECK(std::holds_alternative<Segment>(line[0]));
    CHECK(length_of(line[0]) == doctest::Approx(3 * std::sqrt(2.0)).epsilon(1e-15));
    CHECK(arcs_of_cubic({1, 1}, {1, 1}, {1, 1}, {1, 1}).empty());
}

TEST_CASE("an ellipse is followed within tolerance, a circle is one exact arc") {
    EllipticArc const oval{{1, 2}, {3, 1}, {-0.5, 1}, 0.3, 4 * pi_half};
    auto const at = [&](double t) -> Vec2 {
        double const angle = oval.from + oval.sweep * t;
        return oval.centre + std::cos(angle) * oval.first + std::sin(angle) * oval.second;
    };
    std::vector<Curve> const arcs = arcs_of_ellipse(oval);
    CHECK(deviation(arcs, at) <= drawing_tolerance + 2e-5);
    CHECK(widest_gap(arcs) <= joint_gap);
    CHECK(sharpest_joint(arcs) <= 3e-6);
    std::vector<Curve> const circle = arcs_of_ellipse({{0, 0}, {0, 2}, {2, 0}, 0, pi_half});
    REQUIRE(circle.size() == 1);
    CHECK(length(start_of(circle[0]) - Vec2(0, 2)) <= 1e-15);
    CHECK(length(end_of(circle[0]) - Vec2(2, 0)) <= 1e-15);
}

TEST_CASE("ellipses of any shape, turn and part keep within a millimetre") {
    for (double const size : {0.3, 5.0, 50.0})
        for (double const ratio : {0.999, 0.7, 0.2, -0.5, 0.02, -0.004})
            for (double const from : {0.0, 0.7, -2.3, 3 * pi_half})
                for (double const sweep : {4 * pi_half, -4 * pi_half, 2 * pi_half, -3.7, 0.3}) {
                    CAPTURE(size);
                    CAPTURE(ratio);
                    CAPTURE(from);
                    CAPTURE(sweep);
                    // A direction of 3 : 4, so that neither axis lies on x or y.
                    EllipticArc const part{
                        {1, 2}, {0.6 * size, 0.8 * size}, {-0.8 * size * ratio, 0.6 * size * ratio}, from, sweep};
                    auto const at = [&](double angle) -> Vec2 {
                        return part.centre + std::cos(angle) * part.first + std::sin(angle) * part.second;
                    };
                    std::vector<Curve> const arcs = arcs_of_ellipse(part);
                    double worst = 0;
                    for (int i = 0; i <= 400; ++i)
                        worst = std::max(worst, distance_to(arcs, at(from + sweep * i / 400)));
                    CHECK(worst <= drawing_tolerance);
                    // From the arcs to the ellipse: f = (x / a)^2 + (y / b)^2 - 1 is |grad f| times the distance, to
                    // first order.
                    double astray = 0;
                    for (Curve const& arc : arcs)
                        for (double share = 0; share <= 1; share += 0.125) {
                            Vec2 const p = point_of(arc, share) - part.centre;
                            double const a = size, b = size * ratio;
                            double const x = 0.6 * p.x() + 0.8 * p.y(), y = -0.8 * p.x() + 0.6 * p.y();
                            double const f = x * x / (a * a) + y * y / (b * b) - 1;
                            astray = std::max(astray, std::abs(f) / std::hypot(2 * x / (a * a), 2 * y / (b * b)));
                        }
                    CHECK(astray <= 1.01 * drawing_tolerance);
                    CHECK(widest_gap(arcs) <= joint_gap);
                    CHECK(sharpest_joint(arcs) <= 1e-5);
                    CHECK(length(start_of(arcs.front()) - at(from)) <= 1e-10);
                    CHECK(length(end_of(arcs.back()) - at(from + sweep)) <= 1e-10);
                    for (Curve const& arc : arcs) CHECK(length_of(arc) > 1e-8);
                    CHECK(arcs.size() <= 128);
                }
}

TEST_CASE("the four quarters of an ellipse are mirror images") {
    std::vector<Curve> const arcs = arcs_of_ellipse({{0, 0}, {50, 0}, {0, 17}, 0, 4 * pi_half});
    REQUIRE(arcs.size() % 4 == 0);
    for (std::size_t i = 0; i < arcs.size() / 2; ++i) {
        Arc const above = std::get<Arc>(arcs[i]), below = std::get<Arc>(arcs[arcs.size() - 1 - i]);
        Arc const left = std::get<Arc>(arcs[arcs.size() / 2 - 1 - i]);
        CHECK(above.radius == below.radius);
        CHECK(above.centre == Vec2(below.centre.x(), -below.centre.y()));
        CHECK(above.radius == left.radius);
        CHECK(above.centre == Vec2(-left.centre.x(), left.centre.y()));
    }
}

TEST_CASE("handles drawn in to their ends cost no more than others") {
    // The double root of the inflections lies on the end; a count that halving to the limit would pass a thousandfold.
    CHECK(arcs_of_cubic({11.3, 1.5}, {5.3, 1.2}, {2.1, 1.5}, {2.1, 1.5}).size() < 100);
    std::mt19937_64 random(17);
    std::uniform_real_distribution<double> metres(-50, 50);
    for (int i = 0; i < 2000; ++i) {
        auto const point = [&] { return Vec2(metres(random), metres(random)); };
        Vec2 const a = point(), b = point(), c = point();
        CHECK(arcs_of_cubic(a, b, c, c).size() < 1000);
        CHECK(arcs_of_cubic(a, a, b, c).size() < 1000);
    }
    auto const at = cubic({11.3, 1.5}, {5.3, 1.2}, {2.1, 1.5}, {2.1, 1.5});
    CHECK(deviation(arcs_of_cubic({11.3, 1.5}, {5.3, 1.2}, {2.1, 1.5}, {2.1, 1.5}), at) <= 1e-3);
}

TEST_CASE("long curves that are nearly straight keep within a millimetre too") {
    for (double const bend : {0.5, 0.05, 0.005, 0.0005}) {
        CAPTURE(bend);
        auto const arcs = arcs_of_cubic({0, 50}, {200, 50 - bend}, {400, 50 - bend}, {600, 50});
        CHECK(deviation(arcs, cubic({0, 50}, {200, 50 - bend}, {400, 50 - bend}, {600, 50})) <= 1e-3);
        CHECK(sharpest_joint(arcs) < 1e-3);
        for (Curve const& curve : arcs)
            if (auto const* arc = std::get_if<Arc>(&curve)) CHECK(arc->radius <= 1e6);
    }
}
