// The pages of settings: opened, worked by keys, buttons and the pointer; what changes is kept at once, and what of the
// game hangs on it.
#pragma once

#include "app/play_actions.h"
#include "app/play_game.h"

namespace app {

// What the file of preferences says, told on standard error where it cannot be understood.
void adopt_preferences(PlayGame& game);
// Keeps them; says on standard error why not.
void keep_preferences(PlayGame const& game);

// What is dragged is let go.
void open_settings(PlayGame& game);

void press_in_settings(PlayGame& game, Press const& press);
void point_in_settings(PlayGame& game, Vec2 const& pixel);
void click_in_settings(PlayGame& game, Vec2 const& pixel);

// The page that is open.
std::vector<view::Shape> settings_shapes(PlayGame const& game);

}  // namespace app
