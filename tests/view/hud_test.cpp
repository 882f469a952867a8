#include <algorithm>

#include <doctest/doctest.h>

#include "stages.h"
#include "view/hud.h"

using view::Vec2;

namespace {

struct Rows {
    double top = 1e9, bottom = -1e9;  // pixels
};

// Of the plates, but for one as large as the picture.
Rows rows_of(std::vector<view::Shape> const& shapes, Vec2 const& size) {
    Rows rows;
    for (view::Panel const& panel : view_test::all_of<view::Panel>(shapes)) {
        if (panel.size == size) continue;
        rows.top = std::min(rows.top, panel.corner.y());
        rows.bottom = std::max(rows.bottom, panel.corner.y() + panel.size.y());
    }
    return rows;
}

}  // namespace

TEST_CASE("a toast lies clear of the page of help, and within the picture") {
    for (Vec2 const& size : {Vec2(640, 360), Vec2(1280, 720), Vec2(1024, 768), Vec2(3840, 2160)}) {
        CAPTURE(size.x());
        std::vector<view::KeyHelp> const rows(30, view::KeyHelp{{"A"}, "what it does"});  // fifteen to a column
        Rows const help = rows_of(view::help_shapes("Keys", rows, size), size);
        Rows const toast = rows_of(view::toast_shapes("Saved", 1, size, view::lift_over_help(size)), size);
        CHECK(toast.top >= 0);
        CHECK(toast.bottom <= help.top);
    }
}
