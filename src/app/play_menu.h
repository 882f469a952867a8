// The menu of a pause: what can be chosen, and how.
#pragma once

#include <optional>

#include "app/play_actions.h"
#include "app/play_game.h"
#include "view/menu.h"

namespace app {

enum class Choice { go_on, again, levels, sound, settings, quit };

// The game stands still while it is open; what is dragged is let go.
void open_menu(PlayGame& game);
void close_menu(PlayGame& game);

// What a key, or the pointer at a pixel, chooses in an open menu; volume and the chosen row change at once.
std::optional<Choice> press_in_menu(PlayGame& game, Press const& press);
void point_in_menu(PlayGame& game, Vec2 const& pixel);
std::optional<Choice> click_in_menu(PlayGame& game, Vec2 const& pixel);

std::vector<view::Shape> menu_shapes(PlayGame const& game);

}  // namespace app
