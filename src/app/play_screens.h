// The screens around the game, and what events mean on them: the title, the levels to pick from, the menu.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/play_actions.h"
#include "app/play_game.h"
#include "app/play_menu.h"
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

// The folder's, or those that ship with the file among them. Throws std::runtime_error as above.
Tour tour_of(std::string const& file_or_folder);

std::string title_of(PlayGame const& game);

enum class KeyCommand { stay, quit };

// Of a place in the window, in points, in pixels of the picture.
Vec2 pixel_at(int x, int y, screen::Window const& window);

// So many levels on.
void go_to_level(PlayGame& game, Tour& tour, std::size_t by, screen::Window& window);
void open_picker(PlayGame& game, Tour& tour, screen::Window& window);
// A level, a run or a folder of levels that was dropped on the window. What cannot be opened is told, and all stays as
// it is.
void open_dropped(std::string const& file, PlayGame& game, Tour& tour, screen::Window& window);

// What the button says that opens the settings, on the title and over the levels.
std::string settings_button(PlayGame const& game);

// What means the same on every screen: help, full screen and sound. Whether it was one of these.
bool press_anywhere(Press const& press, PlayGame& game, screen::Window& window);

KeyCommand press_in_picker(Press const& press, PlayGame& game, Tour& tour, screen::Window& window);
void point_in_picker(Vec2 const& pixel, PlayGame const& game, Tour& tour);
void click_in_picker(Vec2 const& pixel, PlayGame& game, Tour& tour, screen::Window& window);

// Under the title nearly every key starts the game.
KeyCommand press_on_title(Press const& press, PlayGame& game, Tour& tour, screen::Window& window);
void click_on_title(Vec2 const& pixel, PlayGame& game, Tour& tour, screen::Window& window);

// The picker, and what lies over it.
view::Picture picture_of(PlayGame const& game, Picker const& picker);

// Does what was chosen in the menu.
KeyCommand follow_choice(std::optional<Choice> const& choice, PlayGame& game, Tour& tour, screen::Window& window);

}  // namespace app
