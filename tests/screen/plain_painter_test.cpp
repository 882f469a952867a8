// What is painted before a renderer is there, by pixels whose colours are known.
#include <doctest/doctest.h>

#include "screen/plain_painter.h"

namespace {

using screen::ChannelOrder;
using screen::PlainPainter;
using view::Colour;

constexpr Colour plain_black{0, 0, 0, 1}, plain_white{1, 1, 1, 1}, plain_red{1, 0, 0, 1};

struct PlainBytes {
    int first, second, third;
    bool operator==(PlainBytes const&) const = default;
};

PlainBytes bytes_at(screen::Pixels const& pixels, int x, int y) {
    auto const* const byte = pixels.rgba.data() + 4 * (y * pixels.width + x);
    return {byte[0], byte[1], byte[2]};
}

screen::Pixels plainly_painted(std::vector<view::Shape> shapes, ChannelOrder order = ChannelOrder::rgba) {
    PlainPainter painter(order);
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
    CHECK(bytes_at(pixels, 0, 0) == PlainBytes{0, 0, 0});
    CHECK(pixels.rgba[3] == 255);
}

TEST_CASE("a plain sky goes from its top colour to its bottom colour") {
    auto const pixels = plainly_painted({view::Sky{plain_black, plain_white}});
    for (int const y : {0, 23, 47}) {
        int const expected = static_cast<int>(255 * (y + 0.5) / 48 + 0.5);
        CHECK(bytes_at(pixels, 5, y) == PlainBytes{expected, expected, expected});
    }
}

TEST_CASE("channels come in the order asked for") {
    CHECK(bytes_at(plainly_painted({view::Sky{plain_red, plain_red}}), 1, 1) == PlainBytes{255, 0, 0});
    CHECK(bytes_at(plainly_painted({view::Sky{plain_red, plain_red}}, ChannelOrder::bgra), 1, 1) ==
          PlainBytes{0, 0, 255});
}

TEST_CASE("a plain area covers half of a pixel that its edge halves") {
    view::Area area;
    area.rings = {{{10, 10}, {30.5, 10}, {30.5, 20}, {10, 20}}};
    area.paint.top = area.paint.bottom = plain_white;
    auto const pixels = plainly_painted({area});
    CHECK(bytes_at(pixels, 20, 15) == PlainBytes{255, 255, 255});
    CHECK(bytes_at(pixels, 30, 15).first == doctest::Approx(127.5).epsilon(0.02));
    CHECK(bytes_at(pixels, 31, 15) == PlainBytes{0, 0, 0});
    CHECK(bytes_at(pixels, 20, 9) == PlainBytes{0, 0, 0});
}

TEST_CASE("plain discs, strokes, arcs and panels are where they are asked for") {
    auto const pixels = plainly_painted({view::Disc{{10, 10}, 5, plain_white, plain_red, 2},
                                         view::Stroke{{20, 10}, {40, 10}, 4, plain_white},
                                         view::ArcStroke{{30, 30}, 10, 0, 3.14159265, 2, plain_red},
                                         view::Panel{{50, 20}, {10, 10}, 0, {1, 1, 1, 0.5F}}});
    CHECK(bytes_at(pixels, 10, 10) == PlainBytes{255, 255, 255});
    CHECK(bytes_at(pixels, 13, 10) == PlainBytes{255, 0, 0});  // the rim
    CHECK(bytes_at(pixels, 17, 10) == PlainBytes{0, 0, 0});
    CHECK(bytes_at(pixels, 30, 9) == PlainBytes{255, 255, 255});
    CHECK(bytes_at(pixels, 30, 13) == PlainBytes{0, 0, 0});
    CHECK(bytes_at(pixels, 30, 39).first > 250);  // angles go clockwise: the lower half
    CHECK(bytes_at(pixels, 30, 19) == PlainBytes{0, 0, 0});
    CHECK(bytes_at(pixels, 55, 25).first == doctest::Approx(127.5).epsilon(0.01));
}

TEST_CASE("a plain shell shows its upper half above and the lower below, and turns") {
    view::Shell shell{{32, 24}, 20};
    shell.own = view::Livery{plain_red, {0, 1, 0, 1}};
    auto const pixels = plainly_painted({shell});
    CHECK(bytes_at(pixels, 32, 7).first > bytes_at(pixels, 32, 7).second);
    CHECK(bytes_at(pixels, 32, 42).second > bytes_at(pixels, 32, 42).first);
    shell.angle = 3.14159265;
    auto const turned = plainly_painted({shell});
    CHECK(bytes_at(turned, 32, 7).second > bytes_at(turned, 32, 7).first);
}

TEST_CASE("plain letters leave ink right of where they begin, on their base line") {
    auto const pixels = plainly_painted({view::Label{{10, 30}, 24, "I", plain_white}});
    int ink = 0, elsewhere = 0;
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 64; ++x)
            (x >= 10 && x < 22 && y >= 10 && y < 31 ? ink : elsewhere) += bytes_at(pixels, x, y).first;
    CHECK(ink > 10 * 255);
    CHECK(elsewhere == 0);
}

TEST_CASE("what lies beyond the frame is cut off") {
    view::Area area;
    area.rings = {{{-500, -500}, {500, -500}, {500, 500}, {-500, 500}}};
    area.paint.top = area.paint.bottom = plain_white;
    auto const pixels = plainly_painted(
        {area, view::Disc{{-2, -2}, 6, plain_red, {}, 0, 0}, view::Label{{60, 47}, 40, "W", plain_red}});
    CHECK(bytes_at(pixels, 63, 0) == PlainBytes{255, 255, 255});
    CHECK(bytes_at(pixels, 0, 0) == PlainBytes{255, 0, 0});
}
