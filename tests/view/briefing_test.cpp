#include "view/briefing.h"

#include <doctest/doctest.h>

#include "view/hud.h"

namespace {

// Where the first panel stands, pixels from above: its upper edge and its lower one.
struct Extent {
    double top = 0, bottom = 0;
};
Extent panel_of(std::vector<view::Shape> const& shapes) {
    for (view::Shape const& shape : shapes)
        if (auto const* panel = std::get_if<view::Panel>(&shape))
            return {panel->corner.y(), panel->corner.y() + panel->size.y()};
    return {};
}

}  // namespace

TEST_CASE("a hint stands at the edge that it is given, and a message above it") {
    level::Level level;
    level.hint = "Roll to the goal, and take the bananas along.";
    for (view::Vec2 const& size : {view::Vec2(640, 360), view::Vec2(1280, 720), view::Vec2(3840, 2160)}) {
        Extent const lower = panel_of(view::briefing_shapes(level, 1, size));
        Extent const upper = panel_of(view::briefing_shapes(level, 1, size, view::Side::upper));
        CHECK((lower.top > size.y() / 2 && lower.bottom < size.y()));
        CHECK((upper.bottom < size.y() / 2 && upper.top > 0));
    }
    CHECK(view::briefing_shapes(level, 0, {1280, 720}).empty());
}
