#include "view/menu.h"

#include <set>

#include <doctest/doctest.h>

using view::Vec2;

TEST_CASE("every row of the menu is found at its place, from the top down, and none beside them") {
    for (Vec2 const& size : {Vec2(1280, 720), Vec2(640, 480), Vec2(1080, 1920)}) {
        std::vector<std::size_t> met;
        for (double y = 0; y < size.y(); ++y)
            if (auto const place = view::menu_place_at(5, Vec2(size.x() / 2, y), size))
                if (met.empty() || met.back() != place->row) met.push_back(place->row);
        CHECK(met == std::vector<std::size_t>{0, 1, 2, 3, 4});
        CHECK(!view::menu_place_at(5, Vec2(0, size.y() / 2), size));
        CHECK(!view::menu_place_at(5, Vec2(size.x() / 2, 0), size));
        CHECK(!view::menu_place_at(0, size / 2, size));
    }
}

TEST_CASE("the way along a bar grows from 0 to 1 to the right") {
    Vec2 const size(1280, 720);
    double before = -1;
    std::set<double> shares;
    for (double x = 0; x < size.x(); ++x)
        if (auto const place = view::menu_place_at(1, Vec2(x, 390), size)) {
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
        return view::menu_shapes("Pause", {{"Go on", {}}, {"Sound", 0.5}}, chosen, Vec2(1280, 720));
    };
    auto const gold_at = [](std::vector<view::Shape> const& all) {
        double y = -1;
        for (view::Shape const& shape : all)
            if (auto const* panel = std::get_if<view::Panel>(&shape);
                panel && panel->colour.red > 0.9f && panel->colour.blue < 0.3f)
                y = panel->corner.y();
        return y;
    };
    CHECK(gold_at(shapes(0)) > 0);
    CHECK(gold_at(shapes(1)) > gold_at(shapes(0)));
}
