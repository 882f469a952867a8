#include <doctest/doctest.h>

#include "screen/occlusion.h"
#include "screen/offscreen.h"
#include "screen/samples.h"

using screen::Box;
using screen::Occlusion;
using namespace samples;

namespace {

int area_of(std::vector<Box> const& boxes) {
    int area = 0;
    for (Box const& box : boxes) area += (box.right - box.left) * (box.bottom - box.top);
    return area;
}

view::Area square(double left, double top, double right, double bottom, view::Colour const& colour) {
    return area({{{left, top}, {right, top}, {right, bottom}, {left, bottom}}}, colour);
}

}  // namespace

TEST_CASE("what is covered later is hidden, what is covered earlier is seen") {
    Occlusion occlusion(64, 48);
    occlusion.cover({16, 16, 48, 32}, 5);
    CHECK(occlusion.hides({17, 17, 40, 30}, 4));
    CHECK(!occlusion.hides({17, 17, 40, 30}, 5));
    CHECK(!occlusion.hides({10, 17, 40, 30}, 4));
    CHECK(!occlusion.hides({200, 17, 300, 30}, 4));
    Box const whole{0, 0, 64, 48};
    CHECK(area_of(occlusion.seen(whole, 4)) == 64 * 48 - 32 * 16);
    CHECK(area_of(occlusion.seen(whole, 5)) == 64 * 48);
    CHECK(occlusion.seen(whole, 5).size() == 1);
    for (Box const& box : occlusion.seen(whole, 4)) CHECK(!occlusion.hides(box, 4));
}

TEST_CASE("what is hidden by an area changes no pixel, and is not left out where it is seen") {
    view::Picture picture = plain(100, 80, white), hidden = picture;
    for (view::Picture* each : {&picture, &hidden}) {
        if (each == &hidden) {
            each->shapes.emplace_back(view::Disc{{50, 40}, 8, black, {}});
            each->shapes.emplace_back(view::Stroke{{40, 40}, {60, 44}, 3, black});
            each->shapes.emplace_back(square(36, 30, 60, 50, black));
        }
        each->shapes.emplace_back(square(13, 9, 90, 71, red));
    }
    screen::Offscreen offscreen;
    auto const bare = offscreen.paint(picture);
    CHECK(offscreen.paint(hidden).rgba == bare.rgba);
    // Half covered, or covered by what is seen through, it is there.
    for (view::Shape const& over :
         {view::Shape{square(50, 0, 100, 80, red)}, view::Shape{square(0, 0, 100, 80, {1, 0, 0, 0.5F})}}) {
        view::Picture seen = plain(100, 80, white);
        seen.shapes.emplace_back(view::Disc{{48, 40}, 20, black, {}});
        seen.shapes.push_back(over);
        CHECK(at(offscreen.paint(seen), 40, 40).green == 0);
    }
}
