#include "view/picker.h"

#include <filesystem>

#include <doctest/doctest.h>

#include "level/level.h"
#include "view/contrast.h"
#include "view/polygon.h"

using view::Ring;
using view::Vec2;

TEST_CASE("what of a ring lies within a box has the area that the two share") {
    geometry::Box const box{Vec2(0, 0), Vec2(4, 2)};
    Ring const around = {{-3, -3}, {9, -3}, {9, 9}, {-3, 9}};
    CHECK(view::signed_area(view::ring_within(around, box)) == doctest::Approx(8));
    Ring const beside = {{5, 0}, {7, 0}, {7, 2}, {5, 2}};
    CHECK(view::ring_within(beside, box).empty());
    Ring const corner = {{3, 1}, {6, 1}, {6, 5}, {3, 5}};
    CHECK(view::signed_area(view::ring_within(corner, box)) == doctest::Approx(1));
    Ring const triangle = {{0, -2}, {4, 2}, {0, 2}};  // its lower corner, half of 2 by 2, lies below
    CHECK(view::signed_area(view::ring_within(triangle, box)) == doctest::Approx(6));
}

TEST_CASE("every tile that is seen is found at its place, and only there") {
    for (std::size_t const count : {1u, 12u, 40u})
        for (std::size_t chosen = 0; chosen < count; chosen += 5) {
            Vec2 const size(1280, 720);
            int found = 0;
            std::vector<bool> seen(count);
            for (double y = 0; y < size.y(); y += 10)
                for (double x = 0; x < size.x(); x += 10)
                    if (auto const tile = view::tile_at(count, chosen, Vec2(x, y), size)) {
                        REQUIRE(*tile < count);
                        seen[*tile] = true;
                        ++found;
                    }
            CHECK(found > 0);
            CHECK(seen[chosen]);
        }
}

TEST_CASE("a thumbnail of every level that ships shows its ground, whoever paints it, against the middle of its sky") {
    int levels = 0;
    for (auto const& entry : std::filesystem::directory_iterator(ASSETS "/levels")) {
        if (entry.path().extension() != ".svg") continue;
        CAPTURE(entry.path().filename().string());
        level::Level const level = level::read_level(entry.path().string());
        view::Thumbnail const thumbnail = view::thumbnail_of(level);
        double ground = 0;
        for (std::vector<Ring> const& body : thumbnail.ground)
            for (Ring const& ring : body) ground += std::abs(view::signed_area(ring));
        CHECK(ground > 0.01 * level.size.x() * level.size.y());
        view::Colour const sky{(thumbnail.sky_top.red + thumbnail.sky_bottom.red) / 2,
                               (thumbnail.sky_top.green + thumbnail.sky_bottom.green) / 2,
                               (thumbnail.sky_top.blue + thumbnail.sky_bottom.blue) / 2, 1};
        CHECK(view::contrast_ratio(view::ground_colour(thumbnail), sky) > 2);
        ++levels;
    }
    CHECK(levels >= 20);
}

TEST_CASE("rows that are not seen are counted, and the bar scrolls towards them alone") {
    CHECK(view::unseen_rows(12, 3) == view::UnseenRows{0, 0});
    CHECK(view::unseen_rows(16, 0) == view::UnseenRows{0, 1});
    CHECK(view::unseen_rows(16, 15) == view::UnseenRows{1, 0});
    CHECK(view::unseen_rows(40, 20) == view::UnseenRows{4, 3});
    for (Vec2 const& size : {Vec2(1280, 720), Vec2(640, 360)}) {
        auto const ways = [&](std::size_t count, std::size_t chosen) {
            std::vector<int> met;
            double const x = size.x() / 2 + 617 * size.x() / 1280;
            for (double y = 0; y < size.y(); ++y)
                if (int const way = view::scroll_at(count, chosen, Vec2(x, y), size); way != 0)
                    if (met.empty() || met.back() != way) met.push_back(way);
            return met;
        };
        CHECK(ways(12, 3).empty());
        CHECK(ways(16, 0) == std::vector<int>{1});
        CHECK(ways(16, 15) == std::vector<int>{-1});
        CHECK(ways(40, 20) == std::vector<int>{-1, 1});
        CHECK(view::scroll_at(40, 20, size / 2, size) == 0);
    }
}
