// A card of rows over the darkened picture, one of which is chosen: the menu of a pause, the pages of settings.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "view/picture.h"

namespace view {

// Pixels of a picture of 1280x720. Rows go down the columns.
struct MenuForm {
    double width = 420;
    std::size_t columns = 1;
    double row_height = 58, row_gap = 10;
    double letters = 23;
    double bar = 156;   // the length of a bar, at the right end of its row
    double below = 34;  // from the last row to the edge of the card, where a hint may stand
};
inline constexpr MenuForm pause_form{};
inline constexpr MenuForm settings_form{640, 1, 50, 8, 21, 180, 62};
inline constexpr MenuForm keys_form{1200, 2, 34, 6, 17, 0, 58};

// What stands at the right end of a row is one of these.
struct MenuRow {
    std::string text;
    std::optional<double> level = std::nullopt;  // in [0, 1], shown as a bar
    std::optional<bool> on = std::nullopt;       // a switch, with `value` beside it
    std::string value = {};
    std::vector<std::string> caps = {};  // keys
    bool waits = false;                  // for a key: `value` says so
};

struct Menu {
    MenuForm form = pause_form;
    std::string title;
    std::vector<MenuRow> rows;
    std::string hint = {};  // below the rows
};
std::vector<Shape> menu_shapes(Menu const& menu, std::size_t chosen, Vec2 const& size);

// The row at a pixel, and what of its bar lies left of the pixel, whether the row has a bar or not.
struct MenuPlace {
    std::size_t row = 0;
    double share = 0;  // in [0, 1]
};
std::optional<MenuPlace> menu_place_at(MenuForm const& form, std::size_t rows, Vec2 const& pixel, Vec2 const& size);

// The row so many columns and rows on; round in its column at the ends.
std::size_t menu_row_from(MenuForm const& form, std::size_t rows, std::size_t chosen, int columns, int down);

// Caps of keys in a line that ends at `right`, as wide as `room` at most, pixels; `middle` is their height's. Where the
// line begins, pixels.
double add_key_caps(std::vector<Shape>& shapes, std::vector<std::string> const& keys, double right, double middle,
                  double room, double letters);

// A button at the upper right corner.
std::vector<Shape> corner_button_shapes(std::string const& text, Vec2 const& size);
bool is_on_corner_button(std::string const& text, Vec2 const& pixel, Vec2 const& size);

}  // namespace view
