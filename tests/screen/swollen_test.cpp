#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

#include "screen/swollen.h"

namespace {

screen::Bitmap empty_bitmap(int width, int height) {
    return {width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(width * height))};
}

std::uint8_t& pixel(screen::Bitmap& bitmap, int x, int y) {
    return bitmap.shares[static_cast<std::size_t>(y * bitmap.width + x)];
}

}  // namespace

TEST_CASE("a dot swells to a disc") {
    screen::Bitmap dot = empty_bitmap(21, 17);
    pixel(dot, 10, 8) = 255;
    screen::Bitmap disc = screen::swollen(dot, 5.25);
    for (int y = 0; y < disc.height; ++y)
        for (int x = 0; x < disc.width; ++x) {
            double const share = std::clamp(5.25 + 0.5 - std::hypot(x - 10, y - 8), 0.0, 1.0);
            CAPTURE(x);
            CAPTURE(y);
            CHECK(std::abs(pixel(disc, x, y) - 255 * share) <= 0.5 + 1e-9);
        }
}

TEST_CASE("swelling goes by the nearest of many dots, and takes nothing away") {
    screen::Bitmap dots = empty_bitmap(40, 30);
    unsigned dice = 1;
    for (int i = 0; i < 25; ++i) {
        dice = dice * 1664525 + 1013904223;
        pixel(dots, static_cast<int>(dice >> 8) % 40, static_cast<int>(dice >> 16) % 30) = 255;
    }
    pixel(dots, 3, 4) = 60;  // less than half covered: its edge is beyond its middle
    screen::Bitmap thick = screen::swollen(dots, 2.5);
    for (int y = 0; y < thick.height; ++y)
        for (int x = 0; x < thick.width; ++x) {
            double nearest = 1e9;
            for (int v = 0; v < dots.height; ++v)
                for (int u = 0; u < dots.width; ++u)
                    if (int const share = pixel(dots, u, v); share > 0) {
                        double const edge = std::max(0.0, 0.5 - share / 255.0);
                        nearest = std::min(nearest, std::sqrt((x - u) * (x - u) + (y - v) * (y - v) + edge * edge));
                    }
            CHECK(std::abs(pixel(thick, x, y) - 255 * std::clamp(3 - nearest, 0.0, 1.0)) <= 0.5 + 1e-6);
            CHECK(pixel(thick, x, y) >= pixel(dots, x, y));
        }
}

TEST_CASE("a bitmap of nothing, or of no size, stays so") {
    CHECK(screen::swollen(empty_bitmap(5, 4), 2).shares == std::vector<std::uint8_t>(20));
    CHECK(screen::swollen(empty_bitmap(0, 0), 2).shares.empty());
}
