#include <cmath>
#include <limits>
#include <set>

#include <doctest/doctest.h>

#include "stages.h"
#include "view/backdrop.h"
#include "view/surface_look.h"

using view::Vec2;
using namespace view_test;

namespace {

level::Level level_of(physics::Material const& material) { return floor_level(16, 9, material); }

std::set<view::Sign> signs_of(physics::Material const& material) {
    std::set<view::Sign> signs;
    for (view::Mark const& mark : view::ground_of(level_of(material)).marks) signs.insert(mark.sign);
    return signs;
}

}  // namespace

TEST_CASE("ice, mud, full grip and rubber have signs of their own, and usual ground has grass and none") {
    using view::Sign;
    CHECK(signs_of({0.9, 0, 0}).empty());
    CHECK(signs_of({0.02, 0, 0}) == std::set{Sign::glint, Sign::sheen});
    CHECK(signs_of({0.9, 0, 0.1}) == std::set{Sign::drop});
    CHECK(signs_of({full_grip, 0, 0}) == std::set{Sign::stud});
    CHECK(signs_of({0.9, 0.9, 0}) == std::set{Sign::coil});
    CHECK(signs_of({0.02, 0.9, 0}) == std::set{Sign::glint, Sign::sheen, Sign::coil});
    CHECK(!view::ground_of(level_of({0.9, 0, 0})).tufts.empty());
    CHECK(view::ground_of(level_of({0.02, 0, 0})).tufts.empty());
}

TEST_CASE("signs lie along the edge, in the ground") {
    for (physics::Material const& material :
         {physics::Material{0.02, 0, 0}, {0.9, 0, 0.1}, {full_grip, 0, 0}, {0.9, 0.9, 0}}) {
        view::Ground const ground = view::ground_of(level_of(material));
        double least = 16, most = 0;
        for (view::Mark const& mark : ground.marks)
            for (Vec2 const& point : {mark.from, mark.to}) {
                CHECK(point.y() <= 1);
                CHECK(point.y() > 0.7);
                least = std::min(least, point.x());
                most = std::max(most, point.x());
            }
        CHECK(least < 1);
        CHECK(most > 15);
    }
}

TEST_CASE("only the stretch that is icy is shown so") {
    level::Level level = level_with({disc_at({2, 1.5})});
    level.surface_names = {"floor", "ice"};
    level::Outline const left = straight({0, 1}, {6, 1}), right = straight({6, 1}, {16, 1});
    level.outlines = {left, right};
    level.scene.terrain =
        physics::terrain_of({{left.curves[0], {}, 0}, {right.curves[0], physics::Material{0.05, 0, 0}, 1}});
    view::Ground const ground = view::ground_of(level);
    REQUIRE(!ground.marks.empty());
    for (view::Mark const& mark : ground.marks) CHECK(mark.from.x() >= 6 - 0.2);
    for (view::Tuft const& tuft : ground.tufts) CHECK(tuft.root.x() <= 6);
}

TEST_CASE("a look that the drawing gives is left alone") {
    level::Level level = level_of({0.02, 0.9, 0.1});
    level.outlines[0].painted = true;
    view::Ground const ground = view::ground_of(level);
    CHECK(ground.marks.empty());
    CHECK(ground.patches.empty());
}

TEST_CASE("a fill that fades goes down the world, however the picture is turned") {
    level::Level level = floor_level(16, 9);
    level::Decoration pit;
    pit.outlines = {block({1, 1}, {9, 8})};
    pit.fill = "#808080";
    pit.fade = level::Fade{"#ff0000", "#0000ff", 0, 0.5, 7, 3};
    level.decorations.push_back(pit);
    for (Vec2 const& right : {Vec2(1, 0), Vec2(0.8, 0.6)}) {
        view::Camera const camera{Vec2(8, 4.5), 80, Vec2(1280, 720), right};
        int met = 0;
        for (view::Area const& area :
             all_of<view::Area>(view::backdrop_shapes(level, view::ground_of(level), camera))) {
            view::Paint const& paint = area.paint;
            if (paint.bottom.alpha != 0.5f) continue;
            ++met;
            CHECK(paint.top.red == 1);
            CHECK(paint.top.alpha == 0);
            CHECK(paint.bottom.blue == 1);
            // Points of the world at the heights where it begins and ends, wherever they lie.
            for (double const x : {2.0, 7.0}) {
                CHECK(geometry::dot(view::pixel_of(camera, {x, 7}), paint.down) == doctest::Approx(paint.top_y));
                CHECK(geometry::dot(view::pixel_of(camera, {x, 3}), paint.down) == doctest::Approx(paint.bottom_y));
            }
        }
        CHECK(met == 1);
    }
}
