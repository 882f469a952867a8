#include <algorithm>
#include <deque>
#include <random>
#include <utility>

#include <doctest/doctest.h>

#include "physics/world/trail.h"

namespace {

using physics::Trail;

void check_same(Trail<int> const& trail, std::deque<int> const& expected) {
    REQUIRE(trail.size() == expected.size());
    REQUIRE(std::equal(trail.begin(), trail.end(), expected.begin(), expected.end()));
    if (expected.empty()) return;
    REQUIRE(trail.front() == expected.front());
    REQUIRE(trail.back() == expected.back());
}

}  // namespace

TEST_CASE("a trail holds what a std::deque holds, whatever is done to both") {
    std::mt19937 dice(1);
    for (int most : {4, 600, 3000}) {  // within a block, about one and over several
        Trail<int> trail;
        std::deque<int> expected;
        for (int turn = 0; turn < 20000; ++turn) {
            auto const size = static_cast<std::ptrdiff_t>(expected.size());
            std::ptrdiff_t const place = static_cast<std::ptrdiff_t>(dice() % (expected.size() + 1));
            unsigned const what = dice() % 1000;
            if (what < 2) {
                trail.forget_before(trail.begin() + place);
                expected.erase(expected.begin(), expected.begin() + place);
            } else if (what < 4) {
                trail.cut(trail.begin() + place);
                expected.erase(expected.begin() + place, expected.end());
            } else if (what == 4 && turn % 7 == 0) {
                trail.clear();
                expected.clear();
            } else if (what < 10) {
                Trail<int> const copy = trail;
                trail = Trail<int>(copy);
                check_same(copy, expected);
            } else if (what < 30) {
                trail.insert(trail.begin() + place, turn);
                expected.insert(expected.begin() + place, turn);
            } else if (what < 200 && size > 0) {
                trail.pop_back();
                expected.pop_back();
            } else if ((what < 300 || size > most) && size > 0) {
                trail.pop_front();
                expected.pop_front();
            } else {
                trail.push_back(turn);
                expected.push_back(turn);
            }
            if (turn % 16 == 0) check_same(trail, expected);
        }
    }
}

TEST_CASE("places of a long trail keep their items while it grows") {
    Trail<int> trail;
    for (int i = 0; i < 300; ++i) trail.push_back(i);
    int const* const item = &trail[280];
    for (int i = 300; i < 5000; ++i) trail.push_back(i);
    CHECK(&trail[280] == item);
    CHECK(*item == 280);
}

TEST_CASE("what was moved from is empty, and can be filled") {
    Trail<int> trail{1, 2, 3, 4, 5, 6, 7, 8, 9};
    trail.pop_front();
    Trail<int> const other = std::move(trail);
    CHECK(other.size() == 8);
    CHECK(trail.empty());
    trail.push_back(7);
    CHECK(trail.size() == 1);
    CHECK(trail.front() == 7);
}
