#include "screen/samples.h"

#include <cmath>

#include <doctest/doctest.h>

#include "screen/offscreen.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STB_IMAGE_IMPLEMENTATION
#include <stb_image.h>
#pragma GCC diagnostic pop

namespace samples {

view::Area area(std::vector<std::vector<Vec2>> const& rings, view::Colour const& colour) {
    view::Area area;
    area.rings = rings;
    area.paint.top = area.paint.bottom = colour;
    return area;
}

view::Picture plain(int width, int height, view::Colour const& colour) {
    view::Picture picture;
    picture.width = width;
    picture.height = height;
    picture.backdrop.emplace_back(view::Sky{colour, colour});
    return picture;
}

view::Picture shapes() {
    view::Picture picture = plain(160, 120, {0.2F, 0.3F, 0.5F, 1});
    picture.shapes.emplace_back(view::Panel{{8.5, 6.25}, {60, 30}, 8, {0, 0, 0, 0.5F}});
    picture.shapes.emplace_back(view::Disc{{40, 70}, 22.5, {0.9F, 0.4F, 0.1F, 1}, {1, 1, 0.6F, 1}, 3});
    picture.shapes.emplace_back(view::Disc{{95, 30}, 20, {1, 1, 1, 0.8F}, {}, 0, 18});
    picture.shapes.emplace_back(view::Stroke{{80, 60}, {150, 110.5}, 6, {0.3F, 0.9F, 0.3F, 0.8F}});
    picture.shapes.emplace_back(view::Stroke{{80, 110}, {150, 66}, 0.5, white});
    picture.shapes.emplace_back(view::ArcStroke{{120, 60}, 32, -2.5, 4, 5, {0.9F, 0.2F, 0.6F, 0.7F}});
    picture.shapes.emplace_back(view::ArcStroke{{40, 70}, 12, 1, -2, 3, black});
    return picture;
}

view::Picture ground() {
    view::Picture picture = plain(160, 120, {0.4F, 0.7F, 1, 1});
    std::vector<Vec2> hill{{0, 120}}, hole;
    for (int x = 0; x <= 160; x += 4) hill.emplace_back(x, 70 + 15 * std::sin(x * 0.05));
    hill.emplace_back(160, 120);
    for (int i = 0; i < 24; ++i) hole.emplace_back(110 + 20 * std::cos(i * 0.2618), 92 + 12 * std::sin(i * 0.2618));
    view::Paint const paint{{0.6F, 0.4F, 0.2F, 1}, {0.3F, 0.2F, 0.1F, 1}, 60, 120, 0.8, {13.5, 120}, 40};
    picture.backdrop.emplace_back(view::Area{{hill, hole}, paint});
    for (std::size_t i = 1; i + 2 < hill.size(); ++i)
        picture.backdrop.emplace_back(view::Stroke{hill[i], hill[i + 1], 4, {0.5F, 0.9F, 0.3F, 1}});
    picture.shapes.emplace_back(view::Disc{{40, 86}, 20, {0, 0, 0, 0.4F}, {}, 0, 12});
    return picture;
}

view::Picture balls() {
    view::Picture picture = plain(160, 120, {0.7F, 0.85F, 1, 1});
    picture.shapes.emplace_back(view::Shell{{50, 60}, 46, 0.4, 0});
    view::Shell runner{{122, 32}, 24, 2.5, 1};
    runner.monkey = {-0.3, 0.2, 1, 0, {0.8, -0.3}};
    picture.shapes.emplace_back(runner);
    view::Shell sleeper{{118, 80}, 14, -1, 2};
    sleeper.monkey.blink = 1;
    picture.shapes.emplace_back(sleeper);
    picture.shapes.emplace_back(view::Shell{{145, 85}, 8, 4, 3});
    picture.shapes.emplace_back(view::Shell{{145, 105}, 4, 0, 4});
    return picture;
}

view::Picture letters() {
    view::Picture picture = plain(160, 120, white);
    picture.shapes.emplace_back(view::Label{{4, 20}, 14, "L = v ∧ n, θ = L / r", black});
    picture.shapes.emplace_back(view::Label{{80.3, 60}, 40, "Goal!", red, view::Anchor::Centre, view::Weight::bold});
    picture.shapes.emplace_back(view::Label{{156, 100}, 11.5, "12.5 m/s, Föhn", blue, view::Anchor::Right});
    return picture;
}

screen::Pixels painted(view::Picture const& picture) {
    // Not taken down: OSMesa ends before what is static here.
    static auto& offscreen = *new screen::Offscreen;
    return offscreen.paint(picture);
}

Rgb at(screen::Pixels const& pixels, int x, int y) {
    std::size_t const i =
        4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(pixels.width) + static_cast<std::size_t>(x));
    return {pixels.rgba.at(i), pixels.rgba.at(i + 1), pixels.rgba.at(i + 2)};
}

screen::Pixels read_png(std::filesystem::path const& file) {
    screen::Pixels pixels;
    int channels = 0;
    stbi_uc* const decoded = stbi_load(file.c_str(), &pixels.width, &pixels.height, &channels, 4);
    REQUIRE(decoded != nullptr);
    pixels.rgba.assign(decoded, decoded + 4 * pixels.width * pixels.height);
    stbi_image_free(decoded);
    return pixels;
}

}  // namespace samples
