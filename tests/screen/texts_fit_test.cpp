// Letters as they are really drawn: none is wider than the plate that it stands on, in any language.
#include <cmath>

#include <doctest/doctest.h>

#include "screen/glyphs.h"
#include "view/briefing.h"
#include "view/ending.h"
#include "view/overlay.h"
#include "view/picker.h"
#include "view/settings_page.h"
#include "view/stages.h"

using game::Language;
using game::Text;
using view::Vec2;

namespace {

Vec2 const least_size(640, 360);

struct Extent {
    double left = 0, right = 0;  // pixels
};
Extent extent_of(view::Label const& label, screen::Glyphs const& glyphs) {
    double const width = glyphs.width_of(label.text, label.height, label.weight);
    double const share = label.anchor == view::Anchor::Left ? 0 : label.anchor == view::Anchor::Right ? 1 : 0.5;
    return {label.at.x() - share * width, label.at.x() + (1 - share) * width};
}

void check_that_texts_fit(std::vector<view::Shape> const& shapes) {
    static screen::Glyphs const glyphs;
    for (view_test::Letters const& letters : view_test::letters_of(shapes)) {
        double const left = letters.plate ? letters.plate->corner.x() : 0;
        double const width = letters.plate ? letters.plate->size.x() : least_size.x();
        Extent const extent = extent_of(letters.label, glyphs);
        INFO(letters.label.text);
        CHECK(extent.left >= left);
        CHECK(extent.right <= left + width);
    }
}

// Left and right of each other on one line, labels do not meet.
void check_that_texts_keep_apart(std::vector<view::Shape> const& shapes) {
    static screen::Glyphs const glyphs;
    std::vector<view::Label> const labels = view_test::all_of<view::Label>(shapes);
    for (std::size_t i = 0; i < labels.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            // Copies make the rim of large letters.
            if (std::abs(labels[i].at.y() - labels[j].at.y()) > 2 || labels[i].text == labels[j].text) continue;
            Extent const a = extent_of(labels[i], glyphs), b = extent_of(labels[j], glyphs);
            INFO(labels[i].text, " | ", labels[j].text);
            CHECK((a.right <= b.left || b.right <= a.left));
        }
}

void check_card(std::vector<view::Shape> const& card) {
    check_that_texts_fit(card);
    check_that_texts_keep_apart(card);
}

level::Level demanding_level() {
    level::Level level;
    level.title = "Ein Level";
    level.pars.time = 12.5;
    level.pars.pulls = 12;
    for (int i = 0; i < 12; ++i) scenes::add_sensor(level, level::Meaning::banana, physics::DiscRegion{{1, 1}, 0.2});
    return level;
}

}  // namespace

TEST_CASE("cards, pages and menus hold their texts in every language") {
    auto const bindings = game::usual_bindings();
    for (Language const language : {Language::english, Language::german}) {
        game::Preferences preferences;
        preferences.language = language;
        std::vector<std::vector<view::Shape>> cards = {
            view::menu_shapes(view::settings_menu(preferences), 0, least_size),
            view::menu_shapes(view::keys_menu(bindings, game::KeyAction::pause, language), 2, least_size),
            view::menu_shapes(view::keys_menu(bindings, std::nullopt, language), 2, least_size),
            view::help_shapes(words(Text::help_title, language), view::key_help(bindings, language), least_size),
            view::title_shapes(0, least_size, words(Text::title_start, language),
                               words(Text::title_keys, language, {"L", "F1", "F11"})),
            view::corner_button_shapes(words(Text::menu_settings, language) + "  F2", least_size)};
        view::MenuRow sound{words(Text::menu_sound_off, language)};
        sound.level = 0.5;
        cards.push_back(view::menu_shapes({view::pause_form,
                                           words(Text::menu_title, language),
                                           {{words(Text::menu_go_on, language)},
                                            {words(Text::menu_again, language)},
                                            {words(Text::menu_levels, language)},
                                            sound,
                                            {words(Text::menu_settings, language)},
                                            {words(Text::menu_quit, language)}}},
                                          0, least_size));
        for (auto const& card : cards) check_card(card);
    }
}

TEST_CASE("every text that may be a message or a badge has room in every language") {
    for (Language const language : {Language::english, Language::german})
        for (std::size_t i = 0; i < game::text_count; ++i) {
            std::string const text =
                words(static_cast<Text>(i), language, {"Page down", "Num Enter", "Backspace", "F11"});
            check_that_texts_fit(view::toast_shapes(text, 1, least_size));
            if (text.size() < 30) check_that_texts_fit(view::badge_shapes(text, least_size));
        }
}

TEST_CASE("what is asked for and what was reached have room in every language") {
    level::Level const level = demanding_level();
    for (Language const language : {Language::english, Language::german}) {
        view::Wording const wording{language, view::key_text("Keypad Enter", language), "→"};
        auto const briefing = view::briefing_shapes(level, 1, least_size, view::Side::lower, wording);
        check_card(briefing);
        view::EndingNote note;
        note.language = language;
        note.best = 10;
        note.film = words(Text::film_button, language) + "  F6";
        note.hint = words(Text::goal_hint, language, {"Enter", "R"});
        view::Moment moment;
        moment.time = 60;
        for (int const pulls : {1, 99})
            for (int const bananas : {0, 12}) {
                moment.status = {};
                moment.status.goal_time = 55.25;
                moment.status.pulls = pulls;
                moment.status.bananas = bananas;
                check_card(view::ending_shapes(level, moment, least_size, note));
            }
        moment.status = {};
        moment.status.fall_time = 55.25;
        note.hint = words(Text::fall_hint, language, {"Enter", view::key_text(",", language)});
        check_that_texts_fit(view::ending_shapes(level, moment, least_size, note));
        check_that_texts_fit(view::picker_picture({view::Tile{}}, 0, least_size, language).shapes);
    }
}

TEST_CASE("overlays hold their words and numbers in every language") {
    level::Level const level = view_test::floor_level(16, 9);
    physics::State start = level.scene.balls[0].start;
    start.velocity = Vec2(-123.45, -678.9);
    start.spin = -1234.5;
    view::Moment moment = view::moment_at(level, view_test::steady_history(start), 0.001);
    moment.forces.pull = physics::Pull{0, Vec2(1, 1)};
    view::Camera camera;
    camera.size = least_size;
    camera.scale = 40;
    for (Language const language : {Language::english, Language::german}) {
        auto const shapes = view::overlay_shapes(level, moment, camera, {true, true, true}, language);
        CHECK(shapes.size() > 20);
        check_that_texts_fit(shapes);
    }
}

TEST_CASE("the letters of German are drawn, each as itself") {
    screen::Glyphs glyphs;
    for (auto const& [umlaut, plain] :
         {std::pair("ä", "a"), {"ö", "o"}, {"ü", "u"}, {"Ä", "A"}, {"Ö", "O"}, {"Ü", "U"}}) {
        auto const line = glyphs.line(view::Label{{}, 40, umlaut, {}}, 0);
        auto const below = glyphs.line(view::Label{{}, 40, plain, {}}, 0);
        REQUIRE((line && below && line->glyphs.size() == 1));
        // The same letter with dots over it: higher, and not the box that stands for what a font lacks.
        CHECK(line->glyphs[0].glyph.height > below->glyphs[0].glyph.height);
        CHECK(line->glyphs[0].glyph.width == doctest::Approx(below->glyphs[0].glyph.width).epsilon(0.2));
    }
    auto const missing = glyphs.line(view::Label{{}, 40, "\xf3\xb0\x80\x80", {}}, 0);  // a private plane
    REQUIRE(missing);
    for (char const* sign : {"ß", "„", "“", "←", "→", "↑", "↓"}) {
        auto const line = glyphs.line(view::Label{{}, 40, sign, {}}, 0);
        REQUIRE(line);
        CHECK(line->glyphs[0].glyph.width > 0);
        CHECK(line->width != missing->width);
    }
}

TEST_CASE("letters change the rows of the atlas that they lie in, and those drawn before none") {
    screen::Glyphs glyphs;
    CHECK(glyphs.changed_top() >= glyphs.changed_bottom());
    auto const first = glyphs.line(view::Label{{}, 40, "a", {}}, 0);
    REQUIRE(first);
    screen::Glyph const& letter = first->glyphs[0].glyph;
    CHECK(glyphs.changed_top() == letter.atlas_y);
    CHECK(glyphs.changed_bottom() == letter.atlas_y + letter.height);
    glyphs.mark_seen();
    glyphs.line(view::Label{{}, 40, "a", {}}, 0);
    CHECK(glyphs.changed_top() >= glyphs.changed_bottom());
}

TEST_CASE("a letter that swells is larger by that on every side, and stands where it stood") {
    screen::Glyphs glyphs;
    view::Label label{{}, 40, "I", {}};
    auto const usual = glyphs.line(label, 0.25);
    label.swell = 5;
    auto const thick = glyphs.line(label, 0.25);
    REQUIRE((usual && thick));
    auto const ink = [&](screen::Glyph const& glyph, int row) {
        double sum = 0;  // pixels
        for (int column = 0; column < glyph.width; ++column)
            sum += glyphs.atlas()[static_cast<std::size_t>((glyph.atlas_y + row) * screen::atlas_side + glyph.atlas_x +
                                                           column)] /
                   255.0;
        return sum;
    };
    screen::Glyph const& before = usual->glyphs[0].glyph;
    screen::Glyph const& after = thick->glyphs[0].glyph;
    CHECK(thick->width == usual->width);
    CHECK(2 * after.left + after.width == 2 * before.left + before.width);
    CHECK(2 * after.top + after.height == 2 * before.top + before.height);
    // The distance is taken from the middles of pixels: half of one to either side is open.
    CHECK(std::abs(ink(after, after.height / 2) - ink(before, before.height / 2) - 2 * 5) <= 1);
}
