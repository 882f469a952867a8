// The screens around the game, and what events mean on them: the title, the levels to pick from, the menu.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <SDL.h>

#include "app/play_game.h"
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

std::string title_of(PlayGame const& game);

enum class KeyCommand { stay, quit };

// Of a place in the window, in points, in pixels of the picture.
Vec2 pixel_at(int x, int y, screen::Window const& window);

// So many levels on.
void go_to_level(PlayGame& game, Tour& tour, std::size_t by, screen::Window& window);
void open_picker(PlayGame& game, Tour& tour, screen::Window& window);

// Whether the event was the picker's.
bool listen_on_picker(SDL_Event const& event, PlayGame& game, Tour& tour, screen::Window& window);
// Under the title nearly every key starts the game.
KeyCommand listen_on_title(SDL_Event const& event, PlayGame& game, Tour& tour, screen::Window& window);
KeyCommand listen_on_menu(SDL_Event const& event, PlayGame& game, Tour& tour, screen::Window& window);
// Whether the menu takes the event, and nothing else does.
bool is_for_menu(SDL_Event const& event);

// Whether the key was one of those for the sound.
bool press_sound_key(SDL_Keycode key, PlayGame& game);

}  // namespace app
