#include <doctest/doctest.h>

#include "stages.h"
#include "view/timeline.h"

using view::Vec2;
using namespace view_test;

namespace {

double knob_of(view::Timeline const& timeline) {
    return std::get<view::Disc>(view::timeline_shapes(timeline, Vec2(1280, 720)).back()).centre.x();
}

}  // namespace

TEST_CASE("the moment under a pixel is the one whose knob would stand there") {
    view::Timeline timeline{10, 10, 30, {}, {}};
    for (double const time : {10.0, 12.5, 29.0, 30.0}) {
        timeline.shown = time;
        CHECK(view::time_at(timeline, Vec2(knob_of(timeline), 712), Vec2(1280, 720)) == doctest::Approx(time));
    }
    CHECK(view::time_at(timeline, Vec2(-50, 712), Vec2(1280, 720)) == 10);
    CHECK(view::time_at(timeline, Vec2(2000, 712), Vec2(1280, 720)) == 30);
    CHECK(view::is_on_timeline(Vec2(600, 712), Vec2(1280, 720)));
    CHECK(view::is_on_timeline(Vec2(600, 690),
                               Vec2(1280, 720)));  // a press that just misses would begin anew after a fall
    CHECK_FALSE(view::is_on_timeline(Vec2(600, 680), Vec2(1280, 720)));
    CHECK(view::is_on_timeline(Vec2(600, 2060), Vec2(3840, 2160)));
    CHECK_FALSE(view::is_on_timeline(Vec2(600, 600), Vec2(1280, 720)));
}

TEST_CASE("the knob of the timeline stands where the shown time lies in what is kept") {
    // The bar runs from 16 to 1264 of 1280 pixels.
    CHECK(knob_of({10, 10, 30, {}, {}}) == doctest::Approx(16));
    CHECK(knob_of({10, 15, 30, {}, {}}) == doctest::Approx(16 + 312));
    CHECK(knob_of({10, 30, 30, {}, {}}) == doctest::Approx(1264));
    CHECK(knob_of({0, 0, 0, {}, {}}) == doctest::Approx(16));
}

TEST_CASE("marks of the timeline have shapes of their own, whatever their colours") {
    auto const counts = [](view::Timeline::Sign sign) {
        view::Timeline timeline{0, 5, 10, {{3, {}, sign}}, {}};
        auto const shapes = view::timeline_shapes(timeline, {1280, 720});
        return std::array{count_of<view::Disc>(shapes), count_of<view::Stroke>(shapes), count_of<view::Area>(shapes)};
    };
    auto const dot = counts(view::Timeline::Sign::dot), flag = counts(view::Timeline::Sign::flag),
               cross = counts(view::Timeline::Sign::cross);
    CHECK(dot != flag);
    CHECK(dot != cross);
    CHECK(flag != cross);
}
