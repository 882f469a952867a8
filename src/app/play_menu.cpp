#include "app/play_menu.h"

#include <iterator>

#include "app/play_sound.h"

namespace app {

namespace {

constexpr Choice choices[] = {Choice::go_on, Choice::again,    Choice::levels,
                              Choice::sound, Choice::settings, Choice::quit};
constexpr std::size_t choice_count = std::size(choices);
constexpr std::size_t sound_row = 3;
static_assert(choices[sound_row] == Choice::sound);

view::Menu pause_menu(PlayGame const& game) {
    game::Preferences const& preferences = game.preferences;
    auto const text = [&](game::Text id) { return game::words(id, language_of(game)); };
    view::MenuRow sound{text(preferences.muted ? game::Text::menu_sound_off : game::Text::menu_sound)};
    sound.level = preferences.muted ? 0 : preferences.volume;
    return {view::pause_form,
            text(game::Text::menu_title),
            {{text(game::Text::menu_go_on)},
             {text(game::Text::menu_again)},
             {text(game::Text::menu_levels)},
             sound,
             {text(game::Text::menu_settings)},
             {text(game::Text::menu_quit)}}};
}

std::optional<Choice> choice_of(std::optional<game::KeyAction> const& action) {
    if (action == game::KeyAction::menu) return Choice::go_on;
    if (action == game::KeyAction::restart) return Choice::again;
    if (action == game::KeyAction::levels) return Choice::levels;
    if (action == game::KeyAction::quit) return Choice::quit;
    return std::nullopt;
}

}  // namespace

void open_menu(PlayGame& game) {
    release(game);
    game.menu_row = 0;
}

void close_menu(PlayGame& game) { game.menu_row.reset(); }

std::optional<Choice> press_in_menu(PlayGame& game, Press const& press) {
    std::size_t& chosen = *game.menu_row;
    if (!press.move) return choice_of(press.action);
    switch (*press.move) {
        case Move::up:
        case Move::down:
            chosen = view::menu_row_from(view::pause_form, choice_count, chosen, 0, press.move == Move::up ? -1 : 1);
            return std::nullopt;
        case Move::left:
        case Move::right:
            if (chosen == sound_row) turn_volume(game, press.move == Move::left ? -1 : 1);
            return std::nullopt;
        case Move::choose:
            return choices[chosen];
        case Move::back:
            break;
    }
    return Choice::go_on;
}

void point_in_menu(PlayGame& game, Vec2 const& pixel) {
    if (auto const place = view::menu_place_at(view::pause_form, choice_count, pixel, game.size))
        game.menu_row = place->row;
}

std::optional<Choice> click_in_menu(PlayGame& game, Vec2 const& pixel) {
    auto const place = view::menu_place_at(view::pause_form, choice_count, pixel, game.size);
    if (!place) return std::nullopt;
    game.menu_row = place->row;
    // On the bar the pointer sets the volume; beside it, it mutes.
    if (place->row == sound_row && place->share > 0) {
        set_volume(game, place->share);
        return std::nullopt;
    }
    return choices[place->row];
}

std::vector<view::Shape> menu_shapes(PlayGame const& game) {
    return view::menu_shapes(pause_menu(game), *game.menu_row, game.size);
}

}  // namespace app
