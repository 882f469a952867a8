#include <cmath>
#include <limits>
#include <stdexcept>

#include <doctest/doctest.h>

#include "screen/offscreen.h"
#include "screen/samples.h"

using namespace samples;
using view::Picture;

namespace {

// One level for the rounding of an 8-bit blend.
constexpr int rounding = 1;

bool is_near(Rgb const& a, Rgb const& b) {
    return std::abs(a.red - b.red) <= rounding && std::abs(a.green - b.green) <= rounding &&
           std::abs(a.blue - b.blue) <= rounding;
}

screen::Pixels painted_on_black(view::Shape const& shape) {
    Picture picture = plain(64, 48, black);
    picture.shapes.push_back(shape);
    return painted(picture);
}

// The share of the pixels inside a ball that change by more than what the eye takes for the same.
double changed_share(double radius, double angle, double other_angle) {
    Picture picture = plain(64, 64, {0.5F, 0.7F, 0.9F, 1}), other = picture;
    picture.shapes.emplace_back(view::Shell{{32, 32}, radius, angle, 0});
    other.shapes.emplace_back(view::Shell{{32, 32}, radius, other_angle, 0});
    auto const a = painted(picture), b = painted(other);
    int changed = 0;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            Rgb const p = at(a, x, y), q = at(b, x, y);
            constexpr int plain_to_see = 40;
            if (std::abs(p.red - q.red) + std::abs(p.green - q.green) + std::abs(p.blue - q.blue) > plain_to_see)
                ++changed;
        }
    return changed / (3.141592653589793 * radius * radius);
}

}  // namespace

TEST_CASE("the top row comes first, red before blue, all opaque") {
    Picture picture = plain(5, 3, black);
    picture.backdrop = {view::Sky{red, blue}};
    auto const pixels = painted(picture);
    REQUIRE(pixels.rgba.size() == 5 * 3 * 4);
    // The middle of the first of three rows lies at a sixth of the gradient.
    CHECK(is_near(at(pixels, 0, 0), {213, 0, 43}));
    CHECK(is_near(at(pixels, 4, 2), {43, 0, 213}));
    for (std::size_t i = 3; i < pixels.rgba.size(); i += 4) CHECK(pixels.rgba[i] == 255);
}

TEST_CASE("BGRA has red and blue changed over and nothing else") {
    screen::Offscreen rgba, bgra(screen::ChannelOrder::bgra);
    auto const a = rgba.paint(shapes());
    auto const b = bgra.paint(shapes());
    REQUIRE(a.rgba.size() == b.rgba.size());
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < a.rgba.size(); i += 4)
        if (a.rgba[i] != b.rgba[i + 2] || a.rgba[i + 1] != b.rgba[i + 1] || a.rgba[i + 2] != b.rgba[i]) ++wrong;
    CHECK(wrong == 0);
}

TEST_CASE("a disc has its fill inside, its rim at the edge and leaves the rest alone") {
    auto const pixels = painted_on_black(view::Disc{{32, 24}, 15, red, blue, 4});
    CHECK(at(pixels, 32, 24) == Rgb{255, 0, 0});
    CHECK(at(pixels, 32 + 12, 24) == Rgb{0, 0, 255});
    CHECK(at(pixels, 32, 24 - 13) == Rgb{0, 0, 255});
    CHECK(at(pixels, 32 + 16, 24) == Rgb{0, 0, 0});
    CHECK(at(pixels, 0, 0) == Rgb{0, 0, 0});
}

TEST_CASE("a disc's light is its area, also when it is smaller than a pixel") {
    for (double const radius : {0.2, 0.7, 3.3, 17.0}) {
        auto const pixels = painted_on_black(view::Disc{{31.7, 24.2}, radius, white, {}});
        double light = 0;
        for (int y = 0; y < 48; ++y)
            for (int x = 0; x < 64; ++x) light += at(pixels, x, y).red / 255.0;
        double const area = 3.141592653589793 * radius * radius;
        // Coverage taken from the distance is not the exact area where an edge curves within a pixel.
        CHECK(light == doctest::Approx(area).epsilon(radius < 1 ? 0.35 : 0.01));
    }
}

TEST_CASE("an upright edge covers a pixel by the part of it that lies inside") {
    for (double const edge : {10.0, 10.25, 10.5, 10.9}) {
        auto const pixels = painted_on_black(view::Panel{{edge, 5}, {30, 30}, 0, white});
        CHECK(is_near(at(pixels, 10, 20), [&] {
            int const level = static_cast<int>(std::lround((11 - edge) * 255));
            return Rgb{level, level, level};
        }()));
        CHECK(at(pixels, 9, 20) == Rgb{0, 0, 0});
        CHECK(at(pixels, 11, 20) == Rgb{255, 255, 255});
    }
}

TEST_CASE("a stroke is as wide as it says, with round ends") {
    auto const pixels = painted_on_black(view::Stroke{{20, 24}, {44, 24}, 8, white});
    CHECK(at(pixels, 32, 20) == Rgb{255, 255, 255});
    CHECK(at(pixels, 32, 27) == Rgb{255, 255, 255});
    CHECK(at(pixels, 32, 19) == Rgb{0, 0, 0});
    CHECK(at(pixels, 32, 28) == Rgb{0, 0, 0});
    CHECK(at(pixels, 17, 24) == Rgb{255, 255, 255});  // the cap, in the middle
    CHECK(at(pixels, 16, 20) == Rgb{0, 0, 0});        // and not at its corner
}

TEST_CASE("an arc runs clockwise on the screen from its first angle, and no further than its sweep") {
    auto const pixels = painted_on_black(view::ArcStroke{{32, 24}, 16, 0, 1.5707963267948966, 4, white});
    CHECK(at(pixels, 43, 35) == Rgb{255, 255, 255});  // at 45 degrees, below on the right
    CHECK(at(pixels, 43, 12) == Rgb{0, 0, 0});
    CHECK(at(pixels, 20, 35) == Rgb{0, 0, 0});
    CHECK(at(pixels, 32, 24) == Rgb{0, 0, 0});
}

TEST_CASE("a see-through ring is painted once everywhere, also where its quads meet") {
    auto const pixels = painted_on_black(view::ArcStroke{{32, 24}, 19, 0.3, 6.283185307179586, 6, {1, 1, 1, 0.5F}});
    for (int i = 0; i < 720; ++i) {
        double const angle = i * 0.008726646259971648;
        int const x = static_cast<int>(32 + 19 * std::cos(angle)), y = static_cast<int>(24 + 19 * std::sin(angle));
        CHECK(is_near(at(pixels, x, y), {128, 128, 128}));
    }
}

TEST_CASE("an area has holes where rings lie in rings") {
    auto const pixels =
        painted_on_black(area({{{4, 4}, {60, 4}, {60, 44}, {4, 44}}, {{20, 10}, {20, 40}, {50, 40}, {50, 10}}}, red));
    CHECK(at(pixels, 10, 20) == Rgb{255, 0, 0});
    CHECK(at(pixels, 30, 20) == Rgb{0, 0, 0});
    CHECK(at(pixels, 55, 43) == Rgb{255, 0, 0});
    CHECK(at(pixels, 2, 2) == Rgb{0, 0, 0});
}

TEST_CASE("grain stays with the world: moved by whole pixels, the same picture") {
    auto const with_origin = [](double x) {
        return painted_on_black(view::Area{{{{0, 0}, {64, 0}, {64, 48}, {0, 48}}}, {red, red, 0, 48, 1, {x, 48}, 37}});
    };
    auto const here = with_origin(3), there = with_origin(10);
    int different = 0, varied = 0;
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 57; ++x) {
            if (std::abs(at(here, x, y).red - at(there, x + 7, y).red) > rounding) ++different;
            if (at(here, x, y).red != at(here, x + 1, y).red) ++varied;
        }
    CHECK(different == 0);
    CHECK(varied > 500);
}

TEST_CASE("a gradient runs along the way down that an area is given, and its grain lies along it") {
    auto const smooth =
        painted_on_black(view::Area{{{{0, 0}, {64, 0}, {64, 48}, {0, 48}}}, {red, blue, 0, 64, 0, {0, 0}, 1, {1, 0}}});
    for (int x : {0, 20, 63}) {
        int const share = static_cast<int>(std::lround((x + 0.5) / 64 * 255));
        CHECK(is_near(at(smooth, x, 30), {255 - share, 0, share}));
    }
    // Down to the right is a quarter turn anticlockwise about the origin: what was at (47 - y, x) is at (x, y).
    auto const grained = [](Vec2 const& origin, Vec2 const& down) {
        return painted_on_black(
            view::Area{{{{0, 0}, {48, 0}, {48, 48}, {0, 48}}}, {red, red, 0, 48, 1, origin, 37, down}});
    };
    auto const upright = grained({0, 0}, {0, 1}), turned = grained({0, 48}, {1, 0});
    int different = 0, varied = 0;
    for (int x = 0; x < 48; ++x)
        for (int y = 0; y < 48; ++y) {
            if (std::abs(at(upright, 47 - y, x).red - at(turned, x, y).red) > rounding) ++different;
            if (std::abs(at(upright, x, y).red - at(turned, x, y).red) > rounding) ++varied;
        }
    CHECK(different < 24);  // where a texel ends in the middle of a pixel
    CHECK(varied > 500);
}

TEST_CASE("the ball's turning is plain to see at every size") {
    for (double const radius : {4.0, 8.0, 14.0, 30.0}) {
        CHECK(changed_share(radius, 0, 3.1415926) > 0.5);
        CHECK(changed_share(radius, 0.3, 0.3 + 1.5707963) > 0.4);
        CHECK(changed_share(radius, 1, 1) == 0);
    }
    CHECK(changed_share(30, 1, 1.1) > 0.08);
}

TEST_CASE("the monkey stays upright while the shell turns about it, leans as told and shuts its eyes") {
    auto const darkness = [](view::Shell const& shell, int x, int y) {
        Picture picture = plain(64, 64, white);
        picture.shapes.emplace_back(shell);
        auto const pixels = painted(picture);
        Rgb const seen = at(pixels, x, y);
        return 765 - seen.red - seen.green - seen.blue;
    };
    view::Shell shell{{32, 32}, 30, 0, 0};
    // An eye's middle lies 0.16 of 0.74 radii aside, 0.22 and 0.12 of 0.74 above the middle.
    int const x = 28, y = 22, dark = 320;
    for (double const angle : {0.0, 1.0, 2.5, 4.0}) {
        shell.angle = angle;
        CHECK(darkness(shell, x, y) > dark);
        CHECK(darkness(shell, 63 - x, y) > dark);
    }
    shell.monkey.blink = 1;
    CHECK(darkness(shell, x, y - 2) < dark);
    shell.monkey.blink = 0;
    shell.monkey.lean = 3.141592653589793;
    CHECK(darkness(shell, x, 63 - y) > dark);
}

TEST_CASE("the ball turns counter-clockwise") {
    Picture picture = plain(64, 64, black);
    picture.shapes.emplace_back(view::Shell{{32, 32}, 30, 1.5707963267948966, 0});
    auto const pixels = painted(picture);
    // Its upper half is red, its lower one yellow, with more green: a quarter turn puts the upper half on the left.
    double left = 0, right = 0;
    for (int y = 10; y < 54; ++y)
        for (int x = 4; x < 28; ++x) {
            left += at(pixels, x, y).green;
            right += at(pixels, 63 - x, y).green;
        }
    CHECK(right > 1.3 * left);
}

TEST_CASE("letters stand on the base line and keep to their anchor") {
    for (auto const anchor : {view::Anchor::Left, view::Anchor::Centre, view::Anchor::Right}) {
        auto const pixels = painted_on_black(view::Label{{32, 30}, 16, "HH", white, anchor});
        int left = 64, right = 0, top = 48, bottom = 0;
        for (int y = 0; y < 48; ++y)
            for (int x = 0; x < 64; ++x)
                if (at(pixels, x, y).red > 127) {
                    left = std::min(left, x);
                    right = std::max(right, x + 1);
                    top = std::min(top, y);
                    bottom = std::max(bottom, y + 1);
                }
        CHECK(bottom == 30);
        CHECK(top < 22);
        double const middle = (left + right) / 2.0;
        if (anchor == view::Anchor::Left) CHECK((left >= 32 && left <= 35));
        if (anchor == view::Anchor::Right) CHECK((right <= 32 && right >= 29));
        if (anchor == view::Anchor::Centre) CHECK(std::abs(middle - 32) <= 1.5);
    }
}

TEST_CASE("more letters than the atlas holds are all drawn") {
    Picture picture = plain(400, 300, black);
    for (int height = 20; height < 300; height += 7)
        picture.shapes.emplace_back(
            view::Label{{0, 1e5}, static_cast<double>(height), "ABCDEFGHIJKLMNOPQRSTUVW", white});
    picture.shapes.emplace_back(view::Label{{2, 290}, 380, "M", white, view::Anchor::Left, view::Weight::bold});
    auto const pixels = screen::Offscreen().paint(picture);
    int lit = 0;
    for (int x = 0; x < 400; ++x) lit += at(pixels, x, 280).red == 255;
    CHECK(lit > 60);
}

TEST_CASE("sizes that cannot be painted are refused by name") {
    screen::Offscreen offscreen;
    for (auto const& [width, height] : {std::pair{0, 10}, {10, -1}, {8193, 10}, {10, 2000000000}}) {
        Picture picture;
        picture.width = width;
        picture.height = height;
        CHECK_THROWS_WITH_AS(offscreen.paint(picture), doctest::Contains(std::to_string(width).c_str()),
                             std::runtime_error);
    }
    CHECK(at(offscreen.paint(plain(1, 1, red)), 0, 0) == Rgb{255, 0, 0});
    CHECK(at(offscreen.paint(plain(8192, 2, blue)), 8191, 1) == Rgb{0, 0, 255});
}

TEST_CASE("places that are not numbers leave the rest of the picture alone") {
    double const nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
    Picture picture = plain(64, 48, blue);
    for (double const bad : {nan, infinite, 1e300}) {
        picture.shapes.emplace_back(view::Disc{{bad, 3}, 5, red, {}});
        picture.shapes.emplace_back(view::Disc{{3, 3}, nan, red, {}});
        picture.shapes.emplace_back(view::Stroke{{bad, 3}, {3, nan}, 5, red});
        picture.shapes.emplace_back(view::Shell{{bad, bad}, 4, 0, -7});
        picture.shapes.emplace_back(view::ArcStroke{{3, bad}, 4, bad, bad, 2, red});
        picture.shapes.emplace_back(view::Panel{{bad, 3}, {3, nan}, bad, red});
        picture.shapes.emplace_back(view::Label{{bad, 3}, 10, "A\xff\xf0", red});
        picture.shapes.emplace_back(area({{{bad, 3}, {3, 3}, {3, nan}}}, {}));
    }
    CHECK(at(painted(picture), 40, 30) == Rgb{0, 0, 255});
}
