#include "app/play_actions.h"

#include <algorithm>

namespace app {

namespace {

std::optional<Move> move_of(SDL_Keycode key) {
    switch (key) {
        case SDLK_UP:
            return Move::up;
        case SDLK_DOWN:
            return Move::down;
        case SDLK_LEFT:
            return Move::left;
        case SDLK_RIGHT:
            return Move::right;
        case SDLK_RETURN:
        case SDLK_KP_ENTER:
        case SDLK_SPACE:
            return Move::choose;
        case SDLK_ESCAPE:
            return Move::back;
        default:
            return std::nullopt;
    }
}

}  // namespace

Press press_of(SDL_KeyboardEvent const& event, game::Bindings const& bindings) {
    Press press;
    press.key = SDL_GetKeyName(event.keysym.sym);
    press.action = game::action_of(bindings, press.key);
    press.move = move_of(event.keysym.sym);
    press.repeats = event.repeat != 0;
    return press;
}

std::string canonical_key(std::string const& name) {
    SDL_Keycode const key = SDL_GetKeyFromName(name.c_str());
    return key == SDLK_UNKNOWN ? std::string() : SDL_GetKeyName(key);
}

bool is_down(game::Bindings const& bindings, game::KeyAction action) {
    Uint8 const* const down = SDL_GetKeyboardState(nullptr);
    auto const& keys = bindings.of(action);
    return std::any_of(keys.begin(), keys.end(), [&](std::string const& key) {
        return down[SDL_GetScancodeFromKey(SDL_GetKeyFromName(key.c_str()))] != 0;
    });
}

}  // namespace app
