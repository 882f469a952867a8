// SDL's events made into what the player does.
#pragma once

#include <SDL.h>

#include "app/play_pad.h"
#include "app/play_screens.h"

namespace app {

// What one event means for the game and its window.
KeyCommand listen(SDL_Event const& event, PlayGame& game, Tour& tour, screen::Window& window);

// The same of a gamepad: a button counts as what it stands for, and one that is pulled out pauses the game.
KeyCommand listen_to_pads(SDL_Event const& event, Pads& pads, PlayGame& game, Tour& tour, screen::Window& window);

// Moves through the past while a key for it is held down.
void scrub_by_keys(PlayGame& game, double elapsed);

}  // namespace app
