#include "view/menu.h"

#include <algorithm>
#include <set>

#include <doctest/doctest.h>

#include "stages.h"

using view::Vec2;

TEST_CASE("every row of a card is found at its place, down the columns, and none beside them") {
    for (auto const& [form, rows] :
         {std::pair(view::pause_form, 6u), {view::settings_form, 8u}, {view::keys_form, 27u}})
        for (Vec2 const& size : {Vec2(1280, 720), Vec2(640, 360), Vec2(640, 480), Vec2(1080, 1920)}) {
            std::vector<std::size_t> met;
            for (double x = 0; x < size.x(); x += size.x() / 16)
                for (double y = 0; y < size.y(); ++y)
                    if (auto const place = view::menu_place_at(form, rows, Vec2(x, y), size))
                        if (std::find(met.begin(), met.end(), place->row) == met.end()) met.push_back(place->row);
            REQUIRE(met.size() == rows);
            for (std::size_t i = 0; i < rows; ++i) CHECK(met[i] == i);
            CHECK(!view::menu_place_at(form, rows, Vec2(0, size.y() / 2), size));
            CHECK(!view::menu_place_at(form, rows, Vec2(size.x() / 2, 0), size));
            CHECK(!view::menu_place_at(form, 0, size / 2, size));
        }
}

TEST_CASE("a choice goes round in its column, and across as far as there is a column") {
    auto const from = [](std::size_t row, int across, int down) {
        return view::menu_row_from(view::keys_form, 27, row, across, down);  // 14 and 13 rows
    };
    CHECK(from(0, 0, 1) == 1);
    CHECK(from(0, 0, -1) == 13);
    CHECK(from(13, 0, 1) == 0);
    CHECK(from(14, 0, -1) == 26);
    CHECK(from(26, 0, 1) == 14);
    CHECK(from(3, 1, 0) == 17);
    CHECK(from(17, -1, 0) == 3);
    CHECK(from(13, 1, 0) == 26);
    CHECK(from(3, -1, 0) == 3);
    CHECK(from(17, 1, 0) == 17);
    CHECK(view::menu_row_from(view::pause_form, 6, 5, 0, 1) == 0);
}

TEST_CASE("the way along a bar grows from 0 to 1 to the right") {
    Vec2 const size(1280, 720);
    double before = -1;
    std::set<double> shares;
    for (double x = 0; x < size.x(); ++x)
        if (auto const place = view::menu_place_at(view::pause_form, 1, Vec2(x, 390), size)) {
            CHECK(place->share >= before);
            before = place->share;
            shares.insert(before);
        }
    CHECK(*shares.begin() == 0);
    CHECK(*shares.rbegin() == 1);
    CHECK(shares.size() > 50);
}

TEST_CASE("the chosen row looks otherwise than the others") {
    auto const shapes = [](std::size_t chosen) {
        return view::menu_shapes({view::pause_form, "Pause", {{"Go on"}, {"Sound", 0.5}}}, chosen, Vec2(1280, 720));
    };
    auto const gold_at = [](std::vector<view::Shape> const& all) {
        double y = -1;
        for (view::Panel const& panel : view_test::all_of<view::Panel>(all))
            if (panel.colour.red > 0.9f && panel.colour.blue < 0.3f) y = panel.corner.y();
        return y;
    };
    CHECK(gold_at(shapes(0)) > 0);
    CHECK(gold_at(shapes(1)) > gold_at(shapes(0)));
}

TEST_CASE("the button at the corner is found where it is drawn") {
    Vec2 const size(1280, 720);
    auto const shapes = view::corner_button_shapes("Settings  F2", size);
    auto const& face = std::get<view::Panel>(shapes[1]);
    CHECK(view::is_on_corner_button("Settings  F2", face.corner + face.size / 2, size));
    CHECK(!view::is_on_corner_button("Settings  F2", face.corner - Vec2(2, 0), size));
    CHECK(!view::is_on_corner_button("Settings  F2", face.corner + face.size + Vec2(0, 2), size));
    CHECK(face.corner.x() + face.size.x() <= size.x());
}
