#include "view/settings_page.h"

#include <algorithm>
#include <iterator>

#include <doctest/doctest.h>

using game::KeyAction;
using game::Language;

namespace {

bool has_row(std::vector<view::KeyHelp> const& rows, std::string const& key, std::string const& meaning) {
    return std::any_of(rows.begin(), rows.end(), [&](view::KeyHelp const& row) {
        return row.meaning == meaning && std::find(row.keys.begin(), row.keys.end(), key) != row.keys.end();
    });
}

}  // namespace

TEST_CASE("help lists every action that has a key, with the keys that hold now and in the language") {
    game::Bindings bindings = game::usual_bindings();
    for (game::ActionRow const& row : game::actions())
        CHECK(has_row(view::key_help(bindings, Language::english), view::key_text(row.keys.front(), Language::english),
                      game::words(row.text, Language::english)));
    bindings = game::rebound(bindings, KeyAction::restart, "F9").bindings;
    auto const rows = view::key_help(bindings, Language::german);
    CHECK(has_row(rows, "F9", game::words(game::Text::restart, Language::german)));
    CHECK(!has_row(rows, "R", game::words(game::Text::restart, Language::german)));
    CHECK(has_row(rows, "Leertaste", game::words(game::Text::pause, Language::german)));
}

TEST_CASE("keys read as they are called in the language") {
    CHECK(view::key_text("Left", Language::english) == "←");
    CHECK(view::key_text(",", Language::german) == "Komma");
    CHECK(view::key_text("Keypad +", Language::english) == "Num +");
    CHECK(view::key_text("F7", Language::german) == "F7");
    CHECK(view::key_text("Ä", Language::german) == "Ä");
}

TEST_CASE("the page of keys has a row for each action, and says which key is waited for") {
    auto const keys = game::usual_bindings();
    view::Menu const page = view::keys_menu(keys, std::nullopt, Language::english);
    REQUIRE(page.rows.size() == view::keys_row_count);
    CHECK(page.rows[static_cast<std::size_t>(KeyAction::pause)].caps == std::vector<std::string>{"Space"});
    CHECK(std::none_of(page.rows.begin(), page.rows.end(), [](view::MenuRow const& row) { return row.waits; }));
    view::Menu const waiting = view::keys_menu(keys, KeyAction::pause, Language::english);
    CHECK(waiting.rows[static_cast<std::size_t>(KeyAction::pause)].waits);
    CHECK(waiting.hint != page.hint);
}

TEST_CASE("the page of settings shows what is preferred, and that reduced motion keeps the picture upright") {
    game::Preferences preferences;
    preferences.language = Language::english;
    auto const on = [&](view::Setting setting) {
        auto const* at = std::find(std::begin(view::settings_rows), std::end(view::settings_rows), setting);
        return view::settings_menu(preferences).rows[static_cast<std::size_t>(at - view::settings_rows)].on;
    };
    CHECK(on(view::Setting::sound) == true);
    CHECK(on(view::Setting::turning) == true);
    CHECK(on(view::Setting::high_contrast) == false);
    CHECK(!on(view::Setting::volume));
    preferences.reduced_motion = preferences.muted = true;
    CHECK(on(view::Setting::sound) == false);
    CHECK(on(view::Setting::turning) == false);
    CHECK(on(view::Setting::reduced_motion) == true);
}
