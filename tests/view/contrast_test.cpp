#include "view/contrast.h"

#include <algorithm>

#include <doctest/doctest.h>

#include "stages.h"
#include "view/hud.h"
#include "view/palette.h"
#include "view/settings_page.h"

using view::Colour;
using view::Vec2;

namespace {

constexpr double readable = 4.5;  // WCAG 2.1, 1.4.3

// The worst ratio of letters to the plate that they stand on, of those that stand on one.
struct Worst {
    double ratio = 21;
    int labels = 0;
};
Worst worst_of(std::vector<view::Shape> const& shapes) {
    Worst worst;
    for (view_test::Letters const& letters : view_test::letters_of(shapes)) {
        if (!letters.plate) continue;
        CHECK(letters.plate->colour.alpha == 1);
        worst.ratio = std::min(worst.ratio, view::contrast_ratio(letters.label.colour, letters.plate->colour));
        ++worst.labels;
    }
    return worst;
}

// Of the outline of six metres of ground: how many discs, how many strokes and how long those are together, pixels.
struct Pattern {
    int discs = 0, strokes = 0;
    double length = 0;
    bool operator==(Pattern const&) const = default;
};
Pattern pattern_of(physics::Material const& material) {
    std::vector<physics::Piece> const pieces{{geometry::Segment{{2, 1}, {8, 1}}, material, 0}};
    view::Camera camera;
    camera.centre = {5, 2};
    Pattern pattern;
    auto const shapes = view::terrain_outlines(physics::terrain_of(pieces), camera);
    pattern.discs = view_test::count_of<view::Disc>(shapes);
    pattern.strokes = view_test::count_of<view::Stroke>(shapes);
    for (view::Stroke const& stroke : view_test::all_of<view::Stroke>(shapes))
        pattern.length += std::round((stroke.to - stroke.from).norm());
    return pattern;
}

}  // namespace

TEST_CASE("in high contrast a name that a colour joins to a thing keeps its hue, and can be read") {
    Colour const orange{0.95F, 0.55F, 0.15F, 1}, paper{1, 1, 0.96F, 0.88F};
    auto const shapes =
        view::in_high_contrast({view::Panel{{0, 0}, {100, 50}, 8, paper}, view::Label{{10, 20}, 16, "spring", orange},
                                view::Label{{10, 40}, 16, "all", {0.1F, 0.1F, 0.1F, 1}}},
                               view::Hue::kept);
    auto const worst = worst_of(shapes);
    CHECK(worst.labels == 2);
    CHECK(worst.ratio >= readable);
    auto const letters = view_test::all_of<view::Label>(shapes);
    CHECK(letters.at(0).colour.red > letters.at(0).colour.green);
    CHECK(letters.at(0).colour.green > letters.at(0).colour.blue);
    CHECK(letters.at(1).colour.red == 0.1F);  // that could be read before
}

TEST_CASE("the contrast of two colours is that of WCAG 2.1") {
    CHECK(view::contrast_ratio(view::colour(0xffffff), view::colour(0x000000)) == doctest::Approx(21));
    CHECK(view::contrast_ratio(view::colour(0x808080), view::colour(0x808080)) == doctest::Approx(1));
    // Two grays that are known for lying at either side of the bound on white.
    CHECK(view::contrast_ratio(view::colour(0x767676), view::colour(0xffffff)) > readable);
    CHECK(view::contrast_ratio(view::colour(0x777777), view::colour(0xffffff)) < readable);
}

TEST_CASE("in high contrast letters are readable on solid plates, on whatever card") {
    Vec2 const size(1280, 720);
    game::Preferences preferences;
    preferences.language = game::Language::english;
    auto const bindings = game::usual_bindings();
    std::vector<std::vector<view::Shape>> const cards = {
        view::menu_shapes(view::settings_menu(preferences), 3, size),
        view::menu_shapes(view::keys_menu(bindings, std::nullopt, game::Language::english), 3, size),
        view::help_shapes("How to play", view::key_help(bindings, game::Language::english), size),
        view::toast_shapes("Saved", 1, size), view::badge_shapes("paused", size)};
    for (auto const& card : cards) {
        Worst const worst = worst_of(view::in_high_contrast(card));
        CHECK(worst.labels > 0);
        CHECK(worst.ratio >= readable);
    }
}

TEST_CASE("outlines tell every kind of ground from every other without colour") {
    std::vector<physics::Material> const kinds = {{0.9, 0, 0}, {0.05, 0, 0}, {2, 0, 0}, {0.9, 0, 0.1}, {0.9, 0.8, 0}};
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        CHECK(pattern_of(kinds[i]).strokes > 0);
        for (std::size_t j = 0; j < i; ++j) CHECK(!(pattern_of(kinds[i]) == pattern_of(kinds[j])));
    }
}

TEST_CASE("the outline of an arc lies on the arc, also where the picture is turned") {
    geometry::Arc const arc{{4, 3}, 2, 0.3, 1.1};
    std::vector<physics::Piece> const pieces{{arc, {}, 0}};
    view::Camera camera;
    camera.centre = {4, 4};
    for (double const turn : {0.0, 0.4}) {
        camera.right = Vec2(std::cos(turn), std::sin(turn));
        auto const shapes = view::terrain_outlines(physics::terrain_of(pieces), camera);
        auto const& drawn = std::get<view::ArcStroke>(shapes.front());
        for (double const share : {0.0, 0.5, 1.0}) {
            double const angle = arc.from + share * arc.sweep, seen = drawn.from + share * drawn.sweep;
            Vec2 const on_arc = arc.centre + arc.radius * Vec2(std::cos(angle), std::sin(angle));
            Vec2 const on_screen = drawn.centre + drawn.radius * Vec2(std::cos(seen), std::sin(seen));
            CHECK((on_screen - view::pixel_of(camera, on_arc)).norm() == doctest::Approx(0).epsilon(1e-9));
        }
    }
}

TEST_CASE("dashes stand where dots stood") {
    auto const shapes = view::dashed({view::Disc{{10, 20}, 3, {}, {}, 0, 0}});
    auto const& dash = std::get<view::Stroke>(shapes.front());
    CHECK((dash.from + dash.to) / 2 == Vec2(10, 20));
    CHECK(dash.to.x() > dash.from.x());
}
