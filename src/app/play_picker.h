// The picker over the levels of a tour: which there are, which is chosen.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "view/picker.h"

namespace app {

using geometry::Vec2;

struct Picker {
    std::vector<view::Tile> tiles;  // by file
    std::size_t chosen = 0;
};

// Reads every level; one that is broken has a tile without a picture.
Picker picker_of(std::vector<std::string> const& files, std::size_t chosen);

// To another tile, by columns and rows, as far as there is one.
void move_choice(Picker& picker, int columns, int rows);

// Shows a row more above (-1) or below (1), where there is one, by a choice in it.
void scroll_picker(Picker& picker, int way);

// The tile under the pointer, if there is one.
std::optional<std::size_t> tile_at(Picker const& picker, Vec2 const& pixel, Vec2 const& size);

}  // namespace app
