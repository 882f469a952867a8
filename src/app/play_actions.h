// Keys and buttons made into what they mean: an action by the player's keys, a move in lists whatever those are.
#pragma once

#include <SDL.h>

#include <optional>
#include <string>

#include "game/actions.h"

namespace app {

// In lists, menus and on pages.
enum class Move { up, down, left, right, choose, back };

struct Press {
    std::optional<game::KeyAction> action = {};
    std::optional<Move> move = {};
    std::string key = {};  // its name; empty of a button
    bool repeats = false;  // the key is held down
};
Press press_of(SDL_KeyboardEvent const& event, game::Bindings const& bindings);

// SDL's own name of a key, whatever the case in which it is written; empty where there is no such key.
std::string canonical_key(std::string const& name);

// Whether one of an action's keys is down.
bool is_down(game::Bindings const& bindings, game::KeyAction action);

}  // namespace app
