// What is painted before a renderer is there, by pixels whose colours are known.
#include <doctest/doctest.h>

#include "screen/plain_painter.h"

namespace {

using screen::ChannelOrder;
using screen::PlainPainter;
using view::Colour;

constexpr Colour black{0, 0, 0, 1}, white{1, 1, 1, 1}, red{1, 0, 0, 1};

struct Bytes {
    int first, second, third;
    bool operator==(Bytes const&) const = default;
};

Bytes at(screen::Pixels const& pixels, int x, int y) {
    auto const* const byte = pixels.rgba.data() + 4 * (y * pixels.width + x);
    return {byte[0], byte[1], byte[2]};
}

screen::Pixels painted(std::vector<view::Shape> shapes, ChannelOrder order = ChannelOrder::rgba) {
    PlainPainter painter(order);
    view::Picture picture;
    picture.width = 64;
    picture.height = 48;
    picture.shapes = std::move(shapes);
    return painter.paint(picture);
}

}  // namespace

TEST_CASE("a plain picture is black where nothing is painted, and opaque") {
    auto const pixels = painted({});
    CHECK(pixels.rgba.size() == 4 * 64 * 48);
    CHECK(at(pixels, 0, 0) == Bytes{0, 0, 0});
    CHECK(pixels.rgba[3] == 255);
}

TEST_CASE("a plain sky goes from its top colour to its bottom colour") {
    auto const pixels = painted({view::Sky{black, white}});
    for (int const y : {0, 23, 47}) {
        int const expected = static_cast<int>(255 * (y + 0.5) / 48 + 0.5);
        CHECK(at(pixels, 5, y) == Bytes{expected, expected, expected});
    }
}

TEST_CASE("channels come in the order asked for") {
    CHECK(at(painted({view::Sky{red, red}}), 1, 1) == Bytes{255, 0, 0});
    CHECK(at(painted({view::Sky{red, red}}, ChannelOrder::bgra), 1, 1) == Bytes{0, 0, 255});
}

TEST_CASE("a plain area covers half of a pixel that its edge halves") {
    view::Area area;
    area.rings = {{{10, 10}, {30.5, 10}, {30.5, 20}, {10, 20}}};
    area.paint.top = area.paint.bottom = white;
    auto const pixels = painted({area});
    CHECK(at(pixels, 20, 15) == Bytes{255, 255, 255});
    CHECK(at(pixels, 30, 15).first == doctest::Approx(127.5).epsilon(0.02));
    CHECK(at(pixels, 31, 15) == Bytes{0, 0, 0});
    CHECK(at(pixels, 20, 9) == Bytes{0, 0, 0});
}

TEST_CASE("plain discs, strokes, arcs and panels are where they are asked for") {
    auto const pixels = painted({view::Disc{{10, 10}, 5, white, red, 2}, view::Stroke{{20, 10}, {40, 10}, 4, white},
                                 view::ArcStroke{{30, 30}, 10, 0, 3.14159265, 2, red},
                                 view::Panel{{50, 20}, {10, 10}, 0, {1, 1, 1, 0.5F}}});
    CHECK(at(pixels, 10, 10) == Bytes{255, 255, 255});
    CHECK(at(pixels, 13, 10) == Bytes{255, 0, 0});  // the rim
    CHECK(at(pixels, 17, 10) == Bytes{0, 0, 0});
    CHECK(at(pixels, 30, 9) == Bytes{255, 255, 255});
    CHECK(at(pixels, 30, 13) == Bytes{0, 0, 0});
    CHECK(at(pixels, 30, 39).first > 250);  // angles go clockwise: the lower half
    CHECK(at(pixels, 30, 19) == Bytes{0, 0, 0});
    CHECK(at(pixels, 55, 25).first == doctest::Approx(127.5).epsilon(0.01));
}

TEST_CASE("a plain shell shows its upper half above and the lower below, and turns") {
    view::Shell shell{{32, 24}, 20};
    shell.own = view::Livery{red, {0, 1, 0, 1}};
    auto const pixels = painted({shell});
    CHECK(at(pixels, 32, 7).first > at(pixels, 32, 7).second);
    CHECK(at(pixels, 32, 42).second > at(pixels, 32, 42).first);
    shell.angle = 3.14159265;
    auto const turned = painted({shell});
    CHECK(at(turned, 32, 7).second > at(turned, 32, 7).first);
}

TEST_CASE("plain letters leave ink right of where they begin, on their base line") {
    auto const pixels = painted({view::Label{{10, 30}, 24, "I", white}});
    int ink = 0, elsewhere = 0;
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 64; ++x)
            (x >= 10 && x < 22 && y >= 10 && y < 31 ? ink : elsewhere) += at(pixels, x, y).first;
    CHECK(ink > 10 * 255);
    CHECK(elsewhere == 0);
}

TEST_CASE("what lies beyond the frame is cut off") {
    view::Area area;
    area.rings = {{{-500, -500}, {500, -500}, {500, 500}, {-500, 500}}};
    area.paint.top = area.paint.bottom = white;
    auto const pixels = painted({area, view::Disc{{-2, -2}, 6, red, {}, 0, 0}, view::Label{{60, 47}, 40, "W", red}});
    CHECK(at(pixels, 63, 0) == Bytes{255, 255, 255});
    CHECK(at(pixels, 0, 0) == Bytes{255, 0, 0});
}
