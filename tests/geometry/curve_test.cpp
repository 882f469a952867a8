#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "geometry/box_tree.h"
#include "geometry/elementary.h"

using namespace geometry;

namespace {

constexpr double tolerance = 1e-14;  // m, a few roundings of coordinates near 10

bool same(Vec2 const& a, Vec2 const& b) { return length(a - b) <= tolerance; }

}  // namespace

TEST_CASE("an arc's ends, tangents and length") {
    Curve const arc = Arc{{1, 2}, 3, 0, pi / 2};
    CHECK(same(start_of(arc), {4, 2}));
    CHECK(same(end_of(arc), {1, 5}));
    CHECK(same(tangent_at_start(arc), {0, 1}));
    CHECK(same(tangent_at_end(arc), {-1, 0}));
    CHECK(length_of(arc) == doctest::Approx(1.5 * pi).epsilon(1e-15));
}

TEST_CASE("reversing swaps the ends and turns the tangents round") {
    for (Curve const& curve : {Curve{Segment{{0, 0}, {3, 4}}}, Curve{Arc{{1, 2}, 3, 0.4, -2}}}) {
        Curve const back = reversed(curve);
        CHECK(same(start_of(back), end_of(curve)));
        CHECK(same(end_of(back), start_of(curve)));
        CHECK(same(tangent_at_start(back), -tangent_at_end(curve)));
        CHECK(same(tangent_at_end(back), -tangent_at_start(curve)));
        CHECK(length_of(back) == doctest::Approx(length_of(curve)).epsilon(1e-15));
    }
}

TEST_CASE("an arc spans its ends and what lies between, in either sense and across a whole turn") {
    Arc const left{{0, 0}, 1, 3, 1}, right{{0, 0}, 1, 4, -1};
    for (Arc const& arc : {left, right}) {
        CHECK(spans(arc, 3));
        CHECK(spans(arc, 4));
        CHECK(spans(arc, 3.5 - 2 * pi));
        CHECK_FALSE(spans(arc, 2.9));
        CHECK_FALSE(spans(arc, 4.1));
    }
    for (double angle = -7; angle < 7; angle += 0.1) CHECK(spans({{0, 0}, 1, 1, 2 * pi}, angle));
}

TEST_CASE("the nearest point of a segment is the foot, or an end beyond it") {
    Segment const floor{{0, 0}, {4, 0}};
    Nearest const foot = nearest_point(floor, {1, 2});
    CHECK(same(foot.point, {1, 0}));
    CHECK(foot.distance == 2);
    CHECK(foot.inside);
    Nearest const end = nearest_point(floor, {7, 4});
    CHECK(same(end.point, {4, 0}));
    CHECK(end.distance == 5);
    CHECK_FALSE(end.inside);
    CHECK(nearest_point(Segment{{1, 1}, {1, 1}}, {4, 5}).distance == 5);
}

TEST_CASE("the nearest point of an arc lies on the ray from the centre, or is an end") {
    Arc const bowl{{0, 0}, 2, -pi, pi};
    Nearest const inside = nearest_point(bowl, {0, -1});
    CHECK(same(inside.point, {0, -2}));
    CHECK(inside.distance == doctest::Approx(1).epsilon(1e-15));
    CHECK(inside.inside);
    Nearest const above = nearest_point(bowl, {3, 4});
    CHECK(same(above.point, {2, 0}));
    CHECK_FALSE(above.inside);
    CHECK(nearest_point(bowl, {0, 0}).distance == 2);
}

TEST_CASE("a box holds its curve and touches it on every side") {
    std::mt19937_64 random(4);
    std::uniform_real_distribution<double> angle(-6, 6);
    for (int i = 0; i < 200; ++i) {
        Arc const arc{{1, -1}, 2, angle(random), angle(random)};
        Vec2 low = Vec2::Constant(1e9), high = Vec2::Constant(-1e9);
        for (int k = 0; k <= 4000; ++k) {
            double const at = arc.from + arc.sweep * k / 4000;
            Vec2 const point = arc.centre + arc.radius * Vec2(std::cos(at), std::sin(at));
            low = low.cwiseMin(point);
            high = high.cwiseMax(point);
        }
        Box const box = box_of(arc);
        // Samples 1.5e-3 rad apart see an extreme to 2 m * (7.5e-4)^2 / 2.
        CHECK((box.low - low).cwiseAbs().maxCoeff() <= 6e-7);
        CHECK((box.high - high).cwiseAbs().maxCoeff() <= 6e-7);
    }
}

TEST_CASE("a tree of boxes finds what looking at each of them finds, once each") {
    std::mt19937_64 random(6);
    std::uniform_real_distribution<double> metres(-50, 50), size(0, 5);
    for (int const count : {0, 1, 3, 4, 5, 17, 500}) {
        std::vector<Box> boxes;
        for (int i = 0; i < count; ++i) {
            Vec2 const corner(metres(random), i % 7 == 0 ? 0 : metres(random));
            boxes.push_back({corner, corner + Vec2(size(random), size(random))});
        }
        BoxTree const tree(boxes);
        for (int i = 0; i < 50; ++i) {
            Vec2 const corner(metres(random), metres(random));
            Box const asked{corner, corner + 3 * Vec2(size(random), size(random))};
            std::vector<int> expected, found;
            for (int k = 0; k < count; ++k)
                if (overlap(boxes[k], asked)) expected.push_back(k);
            tree.each_overlapping(asked, [&found](int index) { found.push_back(index); });
            std::sort(found.begin(), found.end());
            CHECK(found == expected);
        }
    }
}

TEST_CASE("a tree of curves finds all that come within reach of a straight way") {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> metres(-20, 20), size(-3, 3), angle(-pi, pi);
    std::vector<Curve> curves;
    for (int i = 0; i < 300; ++i) {
        Vec2 const place(metres(random), i % 7 == 0 ? 0 : metres(random));
        if (i % 2 == 0)
            curves.push_back(Segment{place, place + Vec2(size(random), i % 6 == 0 ? 0 : size(random))});
        else
            curves.push_back(Arc{place, 0.1 + std::abs(size(random)), angle(random), 2 * angle(random)});
    }
    BoxTree const tree{std::span<Curve const>(curves)};
    for (int i = 0; i < 300; ++i) {
        Vec2 const from(metres(random), metres(random)), to = from + (i % 3) * Vec2(size(random), size(random));
        double const reach = std::abs(size(random));
        std::vector<bool> found(curves.size(), false);
        tree.each_near(stroke_of(from, to, reach),
                       [&found](int index) { found[static_cast<std::size_t>(index)] = true; });
        for (std::size_t k = 0; k < curves.size(); ++k)
            for (int step = 0; step <= 50; ++step)
                if (nearest_point(curves[k], from + (step / 50.0) * (to - from)).distance <= reach) REQUIRE(found[k]);
    }
}

TEST_CASE("next to a chain of a thousand chords a disc that touches it is near to a handful") {
    std::vector<Curve> chords;
    auto const corner = [](int i) {
        SineCosine const turn = sine_cosine(2 * pi * i / 1000);
        return Vec2(4 * turn.cosine, 4 * turn.sine);
    };
    for (int i = 0; i < 1000; ++i) chords.push_back(Segment{corner(i), corner(i + 1)});
    BoxTree const tree{std::span<Curve const>(chords)};
    for (double const distance : {3.5, 4.5})
        for (int i = 0; i < 360; ++i) {
            SineCosine const turn = sine_cosine(i * pi / 180);
            Vec2 const centre = distance * Vec2(turn.cosine, turn.sine);
            int near = 0;
            tree.each_near(stroke_of(centre, centre, 0.5 + 1e-9), [&near](int) { ++near; });
            REQUIRE(near <= 3);
        }
}
