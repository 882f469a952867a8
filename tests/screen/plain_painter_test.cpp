// What is painted before a renderer is there, by pixels whose colours are known.
#include <doctest/doctest.h>

#include "screen/plain_painter.h"
#include "screen/samples.h"

using namespace samples;
using screen::ChannelOrder;

namespace {

screen::Pixels plainly_painted(std::vector<view::Shape> shapes, ChannelOrder order = ChannelOrder::rgba) {
    screen::PlainPainter painter(order);
    view::Picture picture;
    picture.width = 64;
    picture.height = 48;
    picture.shapes = std::move(shapes);
    return painter.paint(picture);
}

}  // namespace

TEST_CASE("a plain picture is black where nothing is painted, and opaque") {
    auto const pixels = plainly_painted({});
    CHECK(pixels.rgba.size() == 4 * 64 * 48);
    CHECK(at(pixels, 0, 0) == Rgb{0, 0, 0});
    CHECK(pixels.rgba[3] == 255);
}

TEST_CASE("a plain sky goes from its top colour to its bottom colour") {
    auto const pixels = plainly_painted({view::Sky{black, white}});
    for (int const y : {0, 23, 47}) {
        int const expected = static_cast<int>(255 * (y + 0.5) / 48 + 0.5);
        CHECK(at(pixels, 5, y) == Rgb{expected, expected, expected});
    }
}

TEST_CASE("channels come in the order asked for") {
    CHECK(at(plainly_painted({view::Sky{red, red}}), 1, 1) == Rgb{255, 0, 0});
    CHECK(at(plainly_painted({view::Sky{red, red}}, ChannelOrder::bgra), 1, 1) == Rgb{0, 0, 255});
}

TEST_CASE("a plain area covers half of a pixel that its edge halves") {
    auto const pixels = plainly_painted({area({{{10, 10}, {30.5, 10}, {30.5, 20}, {10, 20}}}, white)});
    CHECK(at(pixels, 20, 15) == Rgb{255, 255, 255});
    CHECK(at(pixels, 30, 15).red == doctest::Approx(127.5).epsilon(0.02));
    CHECK(at(pixels, 31, 15) == Rgb{0, 0, 0});
    CHECK(at(pixels, 20, 9) == Rgb{0, 0, 0});
}

TEST_CASE("plain discs, strokes, arcs and panels are where they are asked for") {
    auto const pixels = plainly_painted(
        {view::Disc{{10, 10}, 5, white, red, 2}, view::Stroke{{20, 10}, {40, 10}, 4, white},
         view::ArcStroke{{30, 30}, 10, 0, 3.14159265, 2, red}, view::Panel{{50, 20}, {10, 10}, 0, {1, 1, 1, 0.5F}}});
    CHECK(at(pixels, 10, 10) == Rgb{255, 255, 255});
    CHECK(at(pixels, 13, 10) == Rgb{255, 0, 0});  // the rim
    CHECK(at(pixels, 17, 10) == Rgb{0, 0, 0});
    CHECK(at(pixels, 30, 9) == Rgb{255, 255, 255});
    CHECK(at(pixels, 30, 13) == Rgb{0, 0, 0});
    CHECK(at(pixels, 30, 39).red > 250);  // angles go clockwise: the lower half
    CHECK(at(pixels, 30, 19) == Rgb{0, 0, 0});
    CHECK(at(pixels, 55, 25).red == doctest::Approx(127.5).epsilon(0.01));
}

TEST_CASE("a plain shell shows its upper half above and the lower below, and turns") {
    view::Shell shell{{32, 24}, 20};
    shell.own = view::Livery{red, {0, 1, 0, 1}};
    auto const pixels = plainly_painted({shell});
    CHECK(at(pixels, 32, 7).red > at(pixels, 32, 7).green);
    CHECK(at(pixels, 32, 42).green > at(pixels, 32, 42).red);
    shell.angle = 3.14159265;
    auto const turned = plainly_painted({shell});
    CHECK(at(turned, 32, 7).green > at(turned, 32, 7).red);
}

TEST_CASE("plain letters leave ink right of where they begin, on their base line") {
    auto const pixels = plainly_painted({view::Label{{10, 30}, 24, "I", white}});
    int ink = 0, elsewhere = 0;
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 64; ++x) (x >= 10 && x < 22 && y >= 10 && y < 31 ? ink : elsewhere) += at(pixels, x, y).red;
    CHECK(ink > 10 * 255);
    CHECK(elsewhere == 0);
}

TEST_CASE("what lies beyond the frame is cut off") {
    auto const pixels = plainly_painted({area({{{-500, -500}, {500, -500}, {500, 500}, {-500, 500}}}, white),
                                         view::Disc{{-2, -2}, 6, red, {}, 0, 0}, view::Label{{60, 47}, 40, "W", red}});
    CHECK(at(pixels, 63, 0) == Rgb{255, 255, 255});
    CHECK(at(pixels, 0, 0) == Rgb{255, 0, 0});
}
