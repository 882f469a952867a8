#include "app/play_menu.h"

#include <iterator>

#include "app/play_sound.h"

namespace app {

namespace {

constexpr Choice choices[] = {Choice::go_on, Choice::again, Choice::levels, Choice::sound, Choice::quit};
constexpr std::size_t choice_count = std::size(choices);
constexpr std::size_t sound_row = 3;
static_assert(choices[sound_row] == Choice::sound);

std::vector<view::MenuRow> menu_rows(PlayGame const& game) {
    game::Preferences const& preferences = game.preferences;
    double const volume = preferences.muted ? 0 : preferences.volume;
    return {{"Go on", {}},
            {"From the beginning", {}},
            {"Levels", {}},
            {preferences.muted ? "Sound: off" : "Sound", volume},
            {"Quit", {}}};
}

std::optional<Choice> choose_by_key(PlayGame& game, SDL_Keycode key) {
    std::size_t& chosen = *game.menu_row;
    switch (key) {
        case SDLK_UP:
            chosen = (chosen + choice_count - 1) % choice_count;
            return std::nullopt;
        case SDLK_DOWN:
            chosen = (chosen + 1) % choice_count;
            return std::nullopt;
        case SDLK_LEFT:
        case SDLK_RIGHT:
            if (chosen == sound_row) turn_volume(game, key == SDLK_LEFT ? -1 : 1);
            return std::nullopt;
        case SDLK_RETURN:
        case SDLK_KP_ENTER:
        case SDLK_SPACE:
            return choices[chosen];
        case SDLK_ESCAPE:
            return Choice::go_on;
        case SDLK_r:
            return Choice::again;
        case SDLK_l:
            return Choice::levels;
        case SDLK_q:
            return Choice::quit;
        default:
            return std::nullopt;
    }
}

}  // namespace

void open_menu(PlayGame& game) {
    release(game);
    game.menu_row = 0;
}

void close_menu(PlayGame& game) { game.menu_row.reset(); }

std::optional<Choice> choose_in_menu(PlayGame& game, SDL_Event const& event, Vec2 const& pixel) {
    if (event.type == SDL_KEYDOWN) return choose_by_key(game, event.key.keysym.sym);
    bool const is_press = event.type == SDL_MOUSEBUTTONDOWN && event.button.button == SDL_BUTTON_LEFT;
    if (event.type != SDL_MOUSEMOTION && !is_press) return std::nullopt;
    auto const place = view::menu_place_at(choice_count, pixel, game.size);
    if (!place) return std::nullopt;
    game.menu_row = place->row;
    if (!is_press) return std::nullopt;
    // On the bar the pointer sets the volume; beside it, it mutes.
    if (place->row == sound_row && place->share > 0) {
        set_volume(game, place->share);
        return std::nullopt;
    }
    return choices[place->row];
}

std::vector<view::Shape> menu_shapes(PlayGame const& game) {
    return view::menu_shapes("Pause", menu_rows(game), *game.menu_row, game.size);
}

}  // namespace app
