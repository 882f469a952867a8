#include <thread>

#include <doctest/doctest.h>

#include "screen/offscreen.h"
#include "screen/samples.h"

using namespace samples;

namespace {

std::vector<view::Picture> all() { return {shapes(), ground(), balls(), letters()}; }

view::Picture keyed(view::Picture picture, unsigned long long key) {
    picture.backdrop_key = key;
    return picture;
}

}  // namespace

TEST_CASE("a picture's bytes do not depend on what was painted before") {
    for (auto const& picture : all()) {
        screen::Offscreen fresh, used;
        auto const first = fresh.paint(picture);
        for (auto const& other : all()) used.paint(other);
        used.paint(plain(77, 33, red));
        CHECK(used.paint(picture).rgba == first.rgba);
        CHECK(fresh.paint(picture).rgba == first.rgba);
    }
}

TEST_CASE("a kept backdrop gives the bytes of one drawn anew") {
    screen::Offscreen offscreen;
    auto const anew = offscreen.paint(keyed(ground(), 0));
    // It is kept from the second time in a row on.
    for (int i = 0; i < 3; ++i) CHECK(offscreen.paint(keyed(ground(), 7)).rgba == anew.rgba);
    // Another key is another backdrop, and the first key is drawn anew after it.
    CHECK(offscreen.paint(keyed(shapes(), 8)).rgba != anew.rgba);
    CHECK(offscreen.paint(keyed(ground(), 7)).rgba == anew.rgba);
    offscreen.paint(keyed(plain(50, 50, red), 7));
    CHECK(offscreen.paint(keyed(ground(), 7)).rgba == anew.rgba);
}

TEST_CASE("two contexts on one thread do not disturb each other") {
    screen::Offscreen one, two;
    auto const a = one.paint(ground());
    auto const b = two.paint(balls());
    CHECK(one.paint(balls()).rgba == b.rgba);
    CHECK(two.paint(ground()).rgba == a.rgba);
}

TEST_CASE("threads with a context each paint the same bytes") {
    std::vector<std::vector<std::uint8_t>> expected;
    screen::Offscreen offscreen;
    for (auto const& picture : all()) expected.push_back(offscreen.paint(picture).rgba);
    std::vector<int> wrong(3, 0);
    std::vector<std::jthread> threads;
    for (auto& count : wrong)
        threads.emplace_back([&count, &expected] {
            screen::Offscreen own;
            auto const pictures = all();
            for (int round = 0; round < 3; ++round)
                for (std::size_t i = 0; i < pictures.size(); ++i)
                    if (own.paint(pictures[i]).rgba != expected[i]) ++count;
        });
    threads.clear();
    for (int const count : wrong) CHECK(count == 0);
}

TEST_CASE("a context may be used on another thread than it was made on") {
    auto const expected = screen::Offscreen().paint(balls());
    screen::Offscreen offscreen;
    offscreen.paint(shapes());
    std::vector<std::uint8_t> bytes;
    std::jthread([&] { bytes = offscreen.paint(balls()).rgba; }).join();
    CHECK(bytes == expected.rgba);
}
