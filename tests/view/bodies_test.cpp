// Which terrain is earth and which is a hole in it.
#include <doctest/doctest.h>

#include "stages.h"
#include "view/bodies.h"

namespace {

using namespace view_test;

level::Outline circle(Vec2 const& centre, double radius) { return {{geometry::Arc{centre, radius, 0, 2 * pi}}, true}; }

level::Level drawn_with(std::vector<level::Outline> outlines) {
    level::Level level;
    level.size = {160, 90};
    level.outlines = std::move(outlines);
    return level;
}

struct Count {
    int solids = 0, holes = 0;       // bodies with earth of their own, and edges of holes
    std::vector<std::size_t> rings;  // of the solids
};

Count counted(level::Level const& level) {
    Count count;
    for (view::Body const& body : view::bodies_of(level)) {
        body.rings.empty() ? ++count.holes : ++count.solids;
        if (!body.rings.empty()) count.rings.push_back(body.rings.size());
    }
    return count;
}

}  // namespace

TEST_CASE("rings in rings are earth and hole by turns, however many there are and in whatever order") {
    constexpr int rings = 30;
    for (bool const outwards : {false, true}) {
        std::vector<level::Outline> outlines;
        for (int i = 0; i < rings; ++i)
            for (double const x : {40.0, 120.0}) outlines.push_back(circle({x, 45}, outwards ? 1 + i : rings - i));
        Count const count = counted(drawn_with(outlines));
        CHECK(count.solids == rings);
        CHECK(count.holes == rings);
        CHECK(count.rings == std::vector<std::size_t>(rings, 2));  // itself and the hole within
    }
}

TEST_CASE("blocks that cross or stand side by side are no holes in each other") {
    Count const count = counted(drawn_with({block({0, 0}, {10, 2}), block({8, 1}, {9, 7}), block({20, 0}, {30, 2}),
                                            block({21, 0.5}, {29, 1.5}), block({22, 5}, {23, 6})}));
    CHECK(count.solids == 4);
    CHECK(count.holes == 1);
    CHECK(count.rings == std::vector<std::size_t>{1, 1, 2, 1});
}

TEST_CASE("a solid with many holes holds them all") {
    std::vector<level::Outline> outlines = {block({0, 0}, {100, 80})};
    for (int i = 0; i < 25; ++i) outlines.push_back(block({4.0 * i, 10}, {4.0 * i + 2, 12 + 0.1 * i}));
    Count const count = counted(drawn_with(outlines));
    CHECK(count.rings == std::vector<std::size_t>{26});
    CHECK(count.holes == 25);
}
