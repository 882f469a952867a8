// The menu of a game that stands still: rows over the darkened picture, one of which is chosen.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "view/picture.h"

namespace view {

struct MenuRow {
    std::string text;
    std::optional<double> level;  // in [0, 1], shown as a bar, where the row has one
};

std::vector<Shape> menu_shapes(std::string const& title, std::vector<MenuRow> const& rows, std::size_t chosen,
                               Vec2 const& size);

// The row at a pixel, and what of its bar lies left of the pixel, whether the row has a bar or not.
struct MenuPlace {
    std::size_t row = 0;
    double share = 0;  // in [0, 1]
};
std::optional<MenuPlace> menu_place_at(std::size_t rows, Vec2 const& pixel, Vec2 const& size);

}  // namespace view
