#include <doctest/doctest.h>

#include "drawing.h"
#include "geometry/elementary.h"

using namespace drawing;
using geometry::Arc;
using geometry::Segment;
using geometry::Vec2;

namespace {

constexpr double pi = geometry::pi;

// Corners of a path of straight lines, in the world, y up from the bottom of a page 9 m high.
std::vector<Vec2> corners(std::string const& data) {
    std::vector<Vec2> points;
    for (auto const& curve : curves_of(read(lone_path(data)))) {
        REQUIRE(std::holds_alternative<Segment>(curve));
        if (points.empty()) points.push_back(std::get<Segment>(curve).start);
        points.push_back(std::get<Segment>(curve).end);
    }
    for (Vec2& point : points) point.y() = 9 - point.y();
    return points;
}

bool same(std::vector<Vec2> const& a, std::vector<Vec2> const& b) {
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (distance(a[i], b[i]) > 1e-12) return false;
    return true;
}

// The largest distance of points of one chain from the other.
double apart(std::vector<geometry::Curve> const& chain, std::vector<Vec2> const& points) {
    double farthest = 0;
    for (Vec2 const& point : points) {
        double nearest = 1e9;
        for (auto const& curve : chain) nearest = std::min(nearest, geometry::nearest_point(curve, point).distance);
        farthest = std::max(farthest, nearest);
    }
    return farthest;
}

}  // namespace

TEST_CASE("line commands in both cases, with implicit repetition") {
    CHECK(same(corners("M1 1 2 2 3 1"), {{1, 1}, {2, 2}, {3, 1}}));
    CHECK(same(corners("m1 1 2 2 3 1"), {{1, 1}, {3, 3}, {6, 4}}));
    CHECK(same(corners("M1,1H3V4h1v-1 2"), {{1, 1}, {3, 1}, {3, 4}, {4, 4}, {4, 3}, {4, 5}}));
    CHECK(same(corners("M1 1l1 0 0 1z"), {{1, 1}, {2, 1}, {2, 2}, {1, 1}}));
    CHECK(same(corners(" M 1-.5.25 1e0 L+1e-1 , 2.0 "), {{1, -0.5}, {0.25, 1}, {0.1, 2}}));
    CHECK(fault_of(lone_path("M0 0 1e-3.5-2")) == ":3: terrain: d: a number was expected, got nothing");
    CHECK(same(corners("M0 0 1e-3.5-2 1"), {{0, 0}, {0.001, 0.5}, {-2, 1}}));
}

TEST_CASE("after a closed subpath the pen is at its start") {
    auto const level = read(lone_path("M1 1h2v2zl-1 0M5 5m1 1h1"));
    REQUIRE(level.outlines.size() == 3);
    CHECK(level.outlines[0].closed);
    CHECK(!level.outlines[1].closed);
    CHECK(std::get<Segment>(level.outlines[1].curves[0]).end == Vec2(0, 8));
    CHECK(std::get<Segment>(level.outlines[2].curves[0]).start == Vec2(6, 3));
}

TEST_CASE("circular arcs stay arcs, flags need no separators") {
    // From (1, 5) to (3, 5) on the page, clockwise there: over the top, round (2, 5).
    auto const curves = curves_of(read(lone_path("M1 5a1 1 0 012 0")));
    REQUIRE(curves.size() == 1);
    auto const& arc = std::get<Arc>(curves[0]);
    CHECK(distance(arc.centre, {2, 4}) < 1e-15);
    CHECK(arc.radius == 1);
    CHECK(arc.from == doctest::Approx(pi).epsilon(1e-15));
    CHECK(arc.sweep == doctest::Approx(-pi).epsilon(1e-15));
}

TEST_CASE("all four arcs between two points") {
    // Chord from (4, 4) to (6, 4) on the page, radius sqrt 2: quarters and three quarters of circles round (5, 4 -+ 1).
    struct Case {
        char const* flags;
        double centre_up, quarters;  // m from the chord, upwards; turns counter-clockwise
    };
    for (Case const& c : {Case{"0 0", 1, 1}, Case{"0 1", -1, -1}, Case{"1 0", -1, 3}, Case{"1 1", 1, -3}}) {
        auto const curves =
            curves_of(read(lone_path(std::string("M4 4A1.4142135623730951 1.4142135623730951 0 ") + c.flags + " 6 4")));
        REQUIRE(curves.size() == 1);
        auto const& arc = std::get<Arc>(curves[0]);
        CAPTURE(c.flags);
        CHECK(distance(arc.centre, {5, 5 + c.centre_up}) < 1e-14);
        CHECK(arc.sweep == doctest::Approx(c.quarters * pi / 2).epsilon(1e-14));
        CHECK(distance(geometry::end_of(curves[0]), {6, 5}) < 1e-14);
    }
}

TEST_CASE("T16: lines of no length are no surface") { CHECK(curves_of(read(lone_path("M1 5h0h1v0l1 0"))).size() == 2); }

TEST_CASE("radii that do not reach grow, radii of zero make a line, equal ends nothing") {
    Arc const grown = std::get<Arc>(curves_of(read(lone_path("M1 5A.5 .5 0 0 1 3 5")))[0]);
    CHECK(grown.radius == 1);
    CHECK(std::holds_alternative<Segment>(curves_of(read(lone_path("M1 5A0 .5 0 0 1 3 5")))[0]));
    CHECK(curves_of(read(lone_path("M1 5A1 1 0 0 1 1 5h1"))).size() == 1);
}

TEST_CASE("a similarity keeps circles and arcs exact, mirrored ones too") {
    std::string const arc = R"svg(<path class="terrain" fill="none" d="M1 0A1 1 0 0 1 0 1" )svg";
    // By quarter turns of a unit circle's quarter: its centre goes where the transform sends the origin.
    struct Case {
        char const* transform;
        Vec2 centre;
        double radius, quarters;
    };
    for (Case const& c :
         {Case{"translate(5 4)", {5, 5}, 1, -1}, Case{"translate(5,4) scale(2)", {5, 5}, 2, -1},
          Case{"translate(5 4)scale(-1 1)", {5, 5}, 1, 1}, Case{"rotate(90) translate(2 -3)", {3, 7}, 1, -1},
          Case{"matrix(0 2 2 0 5 4)", {5, 5}, 2, 1}, Case{"rotate(30 0 0) , rotate(-30)", {0, 9}, 1, -1}}) {
        auto const curves = curves_of(read(with(arc + "transform=\"" + c.transform + "\"/>")));
        REQUIRE(curves.size() == 1);
        auto const& got = std::get<Arc>(curves[0]);
        CAPTURE(c.transform);
        CHECK(distance(got.centre, c.centre) < 1e-14);
        CHECK(got.radius == doctest::Approx(c.radius).epsilon(1e-14));
        CHECK(got.sweep == doctest::Approx(c.quarters * pi / 2).epsilon(1e-14));
    }
    auto const circle = curves_of(read(with(R"svg(<g transform="translate(5 4)"><circle class="terrain" cx="1" r="0.5"
        transform="rotate(-90)scale(2,-2)"/></g>)svg")));
    REQUIRE(circle.size() == 1);
    CHECK(distance(std::get<Arc>(circle[0]).centre, {5, 7}) < 1e-14);
    CHECK(std::get<Arc>(circle[0]).radius == 1);
    CHECK(std::abs(std::get<Arc>(circle[0]).sweep) == doctest::Approx(2 * pi));
}

TEST_CASE("rotated matrices with few decimals are similarities") {
    auto const level = read(with(
        R"svg(<circle class="banana" cx="5" cy="2" r="0.5" transform="matrix(0.8660254,0.5,-0.5,0.8660254,0,0)"/>)svg"));
    CHECK(std::get<physics::DiscRegion>(level.scene.sensors[0].region).radius == doctest::Approx(0.5).epsilon(1e-7));
}

TEST_CASE("other transforms turn circles into ellipses of arcs within the tolerance") {
    auto const curves = curves_of(
        read(with(R"svg(<circle class="terrain" cx="2" cy="2" r="1" transform="translate(5 0) scale(2 1)"/>)svg")));
    // The ellipse round (9, 7) with half axes 2 and 1.
    std::vector<Vec2> points;
    for (int i = 0; i < 720; ++i) {
        auto const turn = geometry::sine_cosine(i * pi / 360);
        points.emplace_back(9 + 2 * turn.cosine, 7 + turn.sine);
    }
    CHECK(apart(curves, points) <= 1e-3);
    for (std::size_t i = 0; i < curves.size(); ++i) {
        auto const& next = curves[(i + 1) % curves.size()];
        CHECK(distance(geometry::end_of(curves[i]), geometry::start_of(next)) < 1e-9);
        CHECK(geometry::cross(geometry::tangent_at_end(curves[i]), geometry::tangent_at_start(next)) ==
              doctest::Approx(0).epsilon(1e-9));
    }
}

TEST_CASE("an ellipse that its transform makes round is a circle") {
    auto const curves =
        curves_of(read(with(R"svg(<path class="terrain" d="M4 4A2 1 0 0 1 8 4" transform="scale(0.5 1)"/>)svg")));
    REQUIRE(curves.size() == 1);
    CHECK(std::get<Arc>(curves[0]).radius == doctest::Approx(1).epsilon(1e-14));
}

TEST_CASE("Bezier curves become arcs within the tolerance that is asked for") {
    // Cubic from (1, 5) to (9, 5); the point of the Bezier polynomial at t, y up.
    std::vector<Vec2> points;
    for (int i = 0; i <= 500; ++i) {
        double const t = i / 500.0, u = 1 - t;
        points.emplace_back(u * u * u * 1 + 3 * u * u * t * 3 + 3 * u * t * t * 7 + t * t * t * 9,
                            9 - (u * u * u * 5 + 3 * u * u * t * 1 + 3 * u * t * t * 8 + t * t * t * 5));
    }
    auto const coarse = curves_of(read(lone_path("M1 5C3 1 7 8 9 5")));
    CHECK(apart(coarse, points) <= 1e-3);
    auto const fine = curves_of(read(
        with(R"svg(<g data-curve-tolerance="1e-6"><path class="terrain" fill="none" d="M1 5c2 -4 6 3 8 0"/></g>)svg")));
    CHECK(apart(fine, points) <= 1e-6);
    CHECK(fine.size() > coarse.size());
    for (std::size_t i = 1; i < fine.size(); ++i) {
        CHECK(distance(geometry::end_of(fine[i - 1]), geometry::start_of(fine[i])) < 1e-9);
        CHECK(distance(geometry::tangent_at_end(fine[i - 1]), geometry::tangent_at_start(fine[i])) < 1e-6);
    }
}

TEST_CASE("smooth commands mirror the control point before them") {
    auto const ends = [](std::string const& data) {
        auto const curves = curves_of(read(lone_path(data)));
        return std::pair(geometry::end_of(curves.back()), geometry::tangent_at_end(curves.back()));
    };
    auto const [cubic, cubic_way] = ends("M1 5C1 4 3 4 3 5S5 6 5 5");
    auto const [same_cubic, same_way] = ends("M1 5c0-1 2-1 2 0C3 6 5 6 5 5");
    CHECK(distance(cubic, same_cubic) < 1e-12);
    CHECK(distance(cubic_way, same_way) < 1e-9);
    auto const smooth = curves_of(read(lone_path("M1 5Q2 3 3 5T5 5t2 0")));
    auto const plain = curves_of(read(lone_path("M1 5q1-2 2 0Q4 7 5 5Q6 3 7 5")));
    REQUIRE(smooth.size() == plain.size());
    for (std::size_t i = 0; i < smooth.size(); ++i)
        CHECK(distance(geometry::end_of(smooth[i]), geometry::end_of(plain[i])) < 1e-12);
}

TEST_CASE("a cubic on its chord is a line") {
    auto const curves = curves_of(read(lone_path("M1 5C2 5 4 5 6 5")));
    REQUIRE(curves.size() == 1);
    CHECK(std::holds_alternative<Segment>(curves[0]));
}

TEST_CASE("a drawing turned, scaled and mirrored as a whole gives the same shape") {
    std::string const inner = R"svg(<path class="terrain" fill="none" d="M-2 0L-1 0A1 1 0 0 0 1 0L2 1"/>)svg";
    auto const plain = curves_of(read(with("<g transform=\"translate(8 4)\">" + inner + "</g>")));
    auto const mirrored = curves_of(read(with("<g transform=\"translate(8 4) scale(-1 1) \">" + inner + "</g>")));
    auto const turned = curves_of(
        read(with("<g transform=\"translate(8 4) rotate(37) \"><g transform=\"scale(.5)\">" + inner + "</g></g>")));
    auto const turn = geometry::sine_cosine(-37 * pi / 180);
    REQUIRE(plain.size() == 3);
    for (int i = 0; i < 3; ++i) {
        Vec2 const end = geometry::end_of(plain[i]) - Vec2(8, 5);
        CHECK(distance(geometry::end_of(mirrored[i]) - Vec2(8, 5), {-end.x(), end.y()}) < 1e-14);
        CHECK(distance(geometry::end_of(turned[i]) - Vec2(8, 5), geometry::turned(end, turn.cosine, turn.sine) / 2) <
              1e-14);
        CHECK(geometry::length_of(turned[i]) == doctest::Approx(geometry::length_of(plain[i]) / 2).epsilon(1e-13));
    }
}

TEST_CASE("ends within a micrometre are one vertex, also across elements") {
    auto const near = read(with(R"svg(<line class="terrain" x1="0" y1="8" x2="5" y2="8"/>
        <line class="terrain" x1="5.0000009" y1="8" x2="9" y2="8"/>)svg"));
    CHECK(near.scene.terrain.vertices.size() == 3);
    auto const far = read(with(R"svg(<line class="terrain" x1="0" y1="8" x2="5" y2="8"/>
        <line class="terrain" x1="5.000002" y1="8" x2="9" y2="8"/>)svg"));
    CHECK(far.scene.terrain.vertices.size() == 4);
}
