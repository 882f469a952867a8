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

TEST_CASE("the knob of the timeline stands where the shown time lies in what is kept") {
    // The bar runs from 16 to 1264 of 1280 pixels.
    CHECK(knob_of({10, 10, 30, {}, {}}) == doctest::Approx(16));
    CHECK(knob_of({10, 15, 30, {}, {}}) == doctest::Approx(16 + 312));
    CHECK(knob_of({10, 30, 30, {}, {}}) == doctest::Approx(1264));
    CHECK(knob_of({0, 0, 0, {}, {}}) == doctest::Approx(16));
}
