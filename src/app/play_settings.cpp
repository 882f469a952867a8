#include "app/play_settings.h"

#include <algorithm>
#include <iterator>

#include "app/output.h"
#include "app/play_sound.h"
#include "view/settings_page.h"

namespace app {

namespace {

using game::KeyAction;
using game::Text;
using view::Setting;

bool shows_keys(PlayGame const& game) { return game.settings->leaf == SettingsPage::Leaf::keys; }

view::Menu page_of(PlayGame const& game) {
    if (!shows_keys(game)) return view::settings_menu(game.preferences);
    SettingsPage const& page = *game.settings;
    auto const waiting = page.waits ? std::optional(static_cast<KeyAction>(page.row)) : std::nullopt;
    return view::keys_menu(game.bindings, waiting, language_of(game));
}

void turn_leaf(PlayGame& game, SettingsPage::Leaf leaf) { game.settings = SettingsPage{leaf, 0, false}; }

void go_back(PlayGame& game) {
    if (shows_keys(game))
        turn_leaf(game, SettingsPage::Leaf::all);
    else
        game.settings.reset();
}

void flip(PlayGame& game, bool& preference) {
    preference = !preference;
    keep_preferences(game);
}

// The system's, then each in turn.
void turn_language(PlayGame& game, int by) {
    std::optional<game::Language> const order[] = {std::nullopt, game::Language::english, game::Language::german};
    int constexpr count = static_cast<int>(std::size(order));
    auto& language = game.preferences.language;
    int const at = static_cast<int>(std::find(order, order + count, language) - order);
    language = order[(at + by + count) % count];
    keep_preferences(game);
}

// By a side of -1 or 1 it turns on or off, or one further; by 0 it is chosen.
void change_setting(PlayGame& game, Setting setting, int side) {
    game::Preferences& preferences = game.preferences;
    switch (setting) {
        case Setting::keys:
            if (side == 0) turn_leaf(game, SettingsPage::Leaf::keys);
            break;
        case Setting::volume:
            if (side != 0) turn_volume(game, side);
            break;
        case Setting::sound:
            toggle_mute(game);
            break;
        case Setting::turning:
            switch_turning(game);
            break;
        case Setting::reduced_motion:
            flip(game, preferences.reduced_motion);
            break;
        case Setting::high_contrast:
            flip(game, preferences.high_contrast);
            break;
        case Setting::language:
            turn_language(game, side == 0 ? 1 : side);
            break;
        case Setting::back:
            if (side == 0) go_back(game);
            break;
    }
}

void keep_bindings(PlayGame& game, game::Bindings bindings) {
    game.bindings = std::move(bindings);
    game.preferences.keys = game::chosen_keys(game.bindings, game.preferences.keys);
    keep_preferences(game);
}

void choose_key_row(PlayGame& game) {
    std::size_t const row = game.settings->row;
    if (row == view::keys_back_row) return go_back(game);
    if (row < game::action_count) {
        game.settings->waits = true;
        return;
    }
    keep_bindings(game, game::usual_bindings());
    say(game, Text::keys_are_reset);
}

void give_key(PlayGame& game, std::string const& key) {
    game::Language const language = language_of(game);
    auto const action = static_cast<KeyAction>(game.settings->row);
    game.settings->waits = false;
    bool const other_keeps_some = [&] {
        auto const owner = game::action_of(game.bindings, key);
        return owner && game.bindings.of(*owner).size() > 1;
    }();
    game::Rebound rebound = game::rebound(game.bindings, action, key);
    keep_bindings(game, std::move(rebound.bindings));
    std::string const name = game::words(game::row_of(action).text, language), now = view::key_text(key, language);
    if (!rebound.other) return say(game, Text::keys_set, {name, now});
    say(game, other_keeps_some ? Text::keys_taken : Text::keys_swapped,
        {name, now, game::words(game::row_of(*rebound.other).text, language),
         view::first_key_text(game.bindings, *rebound.other, language)});
}

void choose_row(PlayGame& game) {
    if (shows_keys(game)) return choose_key_row(game);
    change_setting(game, view::settings_rows[game.settings->row], 0);
}

void move_in_settings(PlayGame& game, Move move) {
    if (move == Move::back) return go_back(game);
    if (move == Move::choose) return choose_row(game);
    view::Menu const page = page_of(game);
    int const down = move == Move::up ? -1 : move == Move::down ? 1 : 0;
    int const side = move == Move::left ? -1 : move == Move::right ? 1 : 0;
    std::size_t& row = game.settings->row;
    if (side != 0 && !shows_keys(game)) return change_setting(game, view::settings_rows[row], side);
    row = view::menu_row_from(page.form, page.rows.size(), row, side, down);
}

}  // namespace

void adopt_preferences(PlayGame& game) {
    game::ReadPreferences read = game::read_preferences();
    game::Bound bound = game::bindings_of(read.preferences.keys, canonical_key);
    read.faults.insert(read.faults.end(), bound.faults.begin(), bound.faults.end());
    for (std::string const& fault : read.faults) note("smb2d: " + read.file + ": " + fault);
    game.preferences = std::move(read.preferences);
    game.bindings = std::move(bound.bindings);
}

void keep_preferences(PlayGame const& game) {
    try {
        if (auto const aside = game::keep(game.preferences))
            note("smb2d: the preferences could not be read; they are kept as " + aside->string());
    } catch (std::exception const& error) {
        note(std::string("smb2d: ") + error.what());
    }
}

void open_settings(PlayGame& game) {
    release(game);
    game.settings = SettingsPage{};
}

void press_in_settings(PlayGame& game, Press const& press) {
    if (game.settings->waits) {
        if (press.move == Move::back)
            game.settings->waits = false;
        else if (!press.key.empty() && !press.repeats)
            give_key(game, press.key);
        return;
    }
    bool const chooses = press.move == Move::choose || press.move == Move::back;
    if (press.repeats && chooses) return;
    if (press.move)
        move_in_settings(game, *press.move);
    else if (!press.repeats && (press.action == KeyAction::settings || press.action == KeyAction::menu))
        game.settings.reset();
}

void point_in_settings(PlayGame& game, Vec2 const& pixel) {
    if (game.settings->waits) return;
    view::Menu const page = page_of(game);
    if (auto const place = view::menu_place_at(page.form, page.rows.size(), pixel, game.size))
        game.settings->row = place->row;
}

void click_in_settings(PlayGame& game, Vec2 const& pixel) {
    game.settings->waits = false;
    view::Menu const page = page_of(game);
    auto const place = view::menu_place_at(page.form, page.rows.size(), pixel, game.size);
    if (!place) return;
    game.settings->row = place->row;
    bool const is_volume = !shows_keys(game) && view::settings_rows[place->row] == Setting::volume;
    if (!is_volume) return choose_row(game);
    if (place->share > 0) set_volume(game, place->share);
}

std::vector<view::Shape> settings_shapes(PlayGame const& game) {
    view::Menu page = page_of(game);
    // A message takes the place of the hint: over the card it would hide rows.
    if (game.toast.left > 0 && !game.settings->waits) page.hint = game.toast.text;
    return view::menu_shapes(page, game.settings->row, game.size);
}

void switch_turning(PlayGame& game) {
    bool const turned = turning_of(game) == view::Turning::with_gravity;
    game.kept_upright = false;
    game.preferences.turning = !turned;
    keep_preferences(game);
    bool const is_calm = game.preferences.reduced_motion;
    say(game, turned ? Text::picture_upright : is_calm ? Text::picture_calm : Text::picture_turns);
}

std::string key_of(PlayGame const& game, game::KeyAction action) {
    return view::first_key_text(game.bindings, action, language_of(game));
}

view::Turning turning_of(PlayGame const& game) {
    bool const turns = game.preferences.turning && !game.preferences.reduced_motion && !game.kept_upright;
    return turns ? view::Turning::with_gravity : view::Turning::never;
}

view::Lens lens_of(PlayGame const& game) {
    view::Lens lens = game.lens;
    lens.motion = motion_of(game);
    return lens;
}

}  // namespace app
