// The menu of a pause: what can be chosen, and how.
#pragma once

#include <optional>

#include <SDL.h>

#include "app/play_game.h"
#include "view/menu.h"

namespace app {

enum class Choice { go_on, again, levels, sound, quit };

// The game stands still while it is open; what is dragged is let go.
void open_menu(PlayGame& game);
void close_menu(PlayGame& game);

// What an event chooses in an open menu; volume and the chosen row change at once. `pixel` is where the pointer is.
std::optional<Choice> choose_in_menu(PlayGame& game, SDL_Event const& event, Vec2 const& pixel);

std::vector<view::Shape> menu_shapes(PlayGame const& game);

}  // namespace app
