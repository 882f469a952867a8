#include "view/briefing.h"

#include <doctest/doctest.h>

#include "stages.h"
#include "view/hud.h"

using namespace view_test;

TEST_CASE("a hint stands at the edge that it is given, and a message above it") {
    level::Level level;
    level.hint = "Roll to the goal, and take the bananas along.";
    for (view::Vec2 const& size : {view::Vec2(640, 360), view::Vec2(1280, 720), view::Vec2(3840, 2160)}) {
        auto const lower = all_of<view::Panel>(view::briefing_shapes(level, 1, size)).at(0);
        auto const upper = all_of<view::Panel>(view::briefing_shapes(level, 1, size, view::Side::upper)).at(0);
        CHECK((lower.corner.y() > size.y() / 2 && lower.corner.y() + lower.size.y() < size.y()));
        CHECK((upper.corner.y() + upper.size.y() < size.y() / 2 && upper.corner.y() > 0));
    }
    CHECK(view::briefing_shapes(level, 0, {1280, 720}).empty());
}
