#include <cmath>

#include <doctest/doctest.h>

#include "screen/coverage.h"

using geometry::FillRule;
using geometry::Vec2;
using screen::coverage_of;
using Rings = std::vector<std::vector<Vec2>>;

namespace {

// Half a level of rounding, as a share of a pixel.
constexpr double half_level = 0.5001 / 255;

bool holds(screen::Box const& box, int x, int y) {
    return x >= box.left && x < box.right && y >= box.top && y < box.bottom;
}

double value_at(screen::Coverage const& coverage, int x, int y) {
    double value = 0;
    for (auto const& box : coverage.inside) value += holds(box, x, y) ? 1 : 0;
    for (auto const& tile : coverage.edges)
        if (holds({tile.left, tile.top, tile.left + screen::tile_side, tile.top + screen::tile_side}, x, y))
            value += tile.values[static_cast<std::size_t>((y - tile.top) * screen::tile_side + x - tile.left)] / 255.0;
    return value;
}

double total(Rings const& rings, int width, int height, FillRule rule = FillRule::even_odd) {
    auto const coverage = coverage_of(rings, rule, width, height);
    double sum = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) sum += value_at(coverage, x, y);
    return sum;
}

}  // namespace

TEST_CASE("a half-plane covers each pixel by the exact area") {
    // Below the line y = 10.3 + x / 4, which leaves no pixel of these columns through its top or bottom.
    auto const coverage =
        coverage_of({{{-50, 10.3 - 12.5}, {100, 10.3 + 25}, {100, 90}, {-50, 90}}}, FillRule::even_odd, 60, 40);
    for (int x = 0; x < 60; ++x)
        for (int y = 0; y < 40; ++y) {
            double const left = 10.3 + x / 4.0, right = left + 0.25;
            if (std::floor(left) != std::floor(right)) continue;
            double const inside = std::clamp(y + 1 - (left + right) / 2, 0.0, 1.0);
            CHECK(std::abs(value_at(coverage, x, y) - inside) <= half_level);
        }
}

TEST_CASE("a triangle's coverage adds up to its area, in whatever direction it is drawn") {
    Rings const one{{{3.3, 2.1}, {37.7, 9.2}, {12.4, 29.9}}};
    Rings const other{{one[0][2], one[0][1], one[0][0]}};
    double const area = 0.5 * std::abs((37.7 - 3.3) * (29.9 - 2.1) - (12.4 - 3.3) * (9.2 - 2.1));
    // Each pixel of the edge, a hundred or so, is rounded by up to half a level.
    CHECK(std::abs(total(one, 40, 32) - area) < 0.1);
    auto const a = coverage_of(one, FillRule::even_odd, 40, 32), b = coverage_of(other, FillRule::even_odd, 40, 32);
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 40; ++x) CHECK(value_at(a, x, y) == value_at(b, x, y));
}

TEST_CASE("what lies outside of the frame is cut off, on all sides") {
    CHECK(total({{{-1e6, -1e6}, {1e6, -1e6}, {1e6, 1e6}, {-1e6, 1e6}}}, 30, 20) == 600);
    CHECK(total({{{-9, -9}, {-2, -9}, {-2, 50}, {-9, 50}}}, 30, 20) == 0);
    CHECK(total({{{40, 2}, {50, 2}, {50, 5}}}, 30, 20) == 0);
    // Half of it lies to the left: a diamond around the left edge's middle.
    CHECK(std::abs(total({{{-8, 10}, {0, 2}, {8, 10}, {0, 18}}}, 30, 20) - 64) < 0.1);
}

TEST_CASE("two rings over each other leave a hole, wherever they turn") {
    std::vector<Vec2> const outer{{0, 0}, {20, 0}, {20, 20}, {0, 20}}, inner{{5, 5}, {15, 5}, {15, 15}, {5, 15}},
        turned{{5, 15}, {15, 15}, {15, 5}, {5, 5}};
    CHECK(total({outer, inner}, 30, 30) == 300);
    CHECK(total({outer, turned}, 30, 30) == 300);
    CHECK(total({outer, outer}, 30, 30) == 0);
}

TEST_CASE("by the nonzero rule a ring within a ring is a hole only where it goes the other way") {
    Rings const one{{{2, 2}, {30, 2}, {30, 20}, {2, 20}}};
    std::vector<Vec2> const inner{{5.5, 4}, {20.5, 4}, {20.5, 10.25}, {5.5, 10.25}};
    Rings const same{one[0], inner}, other{one[0], {inner.rbegin(), inner.rend()}};
    double const whole = 28 * 18, hole = 15 * 6.25;
    CHECK(std::abs(total(one, 40, 32, FillRule::nonzero) - whole) < 0.1);
    CHECK(std::abs(total(same, 40, 32, FillRule::nonzero) - whole) < 0.1);
    CHECK(std::abs(total(other, 40, 32, FillRule::nonzero) - (whole - hole)) < 0.1);
    CHECK(std::abs(total(same, 40, 32, FillRule::even_odd) - (whole - hole)) < 0.1);
    CHECK(std::abs(total(other, 40, 32, FillRule::even_odd) - (whole - hole)) < 0.1);
}

TEST_CASE("tiles are painted once each") {
    Rings const rings{{{-5, 30}, {90, 3}, {210, 60}, {120, 190}, {20, 150}}, {{60, 60}, {120, 60}, {90, 110}}};
    auto const coverage = coverage_of(rings, FillRule::even_odd, 200, 160);
    CHECK_FALSE(coverage.inside.empty());
    for (int y = 0; y < 160; ++y)
        for (int x = 0; x < 200; ++x) CHECK(value_at(coverage, x, y) <= 1);
}

TEST_CASE("rings with fewer than three points, or none, cover nothing") {
    CHECK(total(Rings{}, 9, 9) == 0);
    CHECK(total(Rings{{}}, 9, 9) == 0);
    CHECK(total({{{3, 3}}}, 9, 9) == 0);
    CHECK(total({{{3, 3}, {7, 8}}}, 9, 9) == 0);
}

TEST_CASE("the part of an edge tile that is painted is the least that holds its blocks of four with anything in them") {
    screen::EdgeTile tile{32, 48, {}};
    auto const is = [&](int left, int top, int right, int bottom) {
        screen::Box const part = screen::seen_part_of(tile);
        return part.left == left && part.top == top && part.right == right && part.bottom == bottom;
    };
    CHECK(is(32, 48, 32, 48));
    tile.values[16 * 5 + 9] = 1;  // 9 to the right, 5 down
    CHECK(is(40, 52, 44, 56));
    tile.values[16 * 8 + 3] = 255;
    CHECK(is(32, 52, 44, 60));
    tile.values.fill(7);
    CHECK(is(32, 48, 48, 64));
}
