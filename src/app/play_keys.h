// SDL's events made into what the player does.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <SDL.h>

#include "app/play_game.h"
#include "app/play_pad.h"
#include "app/play_picker.h"
#include "screen/window.h"

namespace app {

// The levels that Tab and PageUp walk through, and where among them the game is.
struct Tour {
    std::vector<std::string> files;
    std::size_t at = 0;
    std::optional<Picker> picker;  // while it is open
};
// The levels that ship with the file among them.
Tour tour_from(std::string const& file);
// The levels in a folder, by name, from the first that can be opened on; its picker is open. Throws std::runtime_error
// where there is none.
Tour tour_of_folder(std::string const& folder);

enum class KeyCommand { stay, quit };

// What one event means for the game and its window.
KeyCommand listen(SDL_Event const& event, PlayGame& game, Tour& tour, screen::Window& window);

// The same of a gamepad: a button counts as the key that it stands for, and one that is pulled out pauses the game.
KeyCommand listen_to_pads(SDL_Event const& event, Pads& pads, PlayGame& game, Tour& tour, screen::Window& window);

// Moves through the past while comma or period is held down.
void scrub_by_keys(PlayGame& game, double elapsed);

std::string title_of(PlayGame const& game);

}  // namespace app
