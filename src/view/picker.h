// The picker: the levels of a game as small pictures, with what was reached in them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "game/medals.h"
#include "game/texts.h"
#include "level/level.h"
#include "view/picture.h"
#include "view/polygon.h"

namespace view {

// A level drawn small: its ground as a shape before its sky, in metres, cut to the level's frame.
struct Thumbnail {
    Vec2 extent = Vec2(16, 9);  // m
    Colour sky_top, sky_bottom;
    std::vector<std::vector<Ring>> ground;  // bodies, each filled by the even-odd rule
    std::vector<Vec2> bananas;
    std::optional<Vec2> goal;
    Vec2 ball = Vec2::Zero();
    double radius = 0.5;  // m, of the ball
};
Thumbnail thumbnail_of(level::Level const& level);
// What ground is painted with: dark, or light where dark does not stand out from the sky, as at night.
Colour ground_colour(Thumbnail const& thumbnail);

struct Tile {
    std::string title;
    std::optional<Thumbnail> thumbnail;  // none where the level is broken
    game::Medal medal = game::Medal::none;
    std::optional<double> best;  // s
};

// Which part of a ring lies within a box: a ring again, by the way along the box's edges (Sutherland and Hodgman).
Ring ring_within(Ring const& ring, geometry::Box const& box);

// Rows of so many tiles; of many rows those around the chosen one are seen.
inline constexpr int picker_columns = 4;
inline constexpr int picker_rows = 3;

Picture picker_picture(std::vector<Tile> const& tiles, std::size_t chosen, Vec2 const& size,
                       game::Language language = game::Language::english);

// How many rows are not seen, above and below.
struct UnseenRows {
    std::size_t above = 0, below = 0;
    bool operator==(UnseenRows const&) const = default;
};
UnseenRows unseen_rows(std::size_t tiles, std::size_t chosen);

// At the right edge, where there are such rows: a bar that says what part of all is seen, and an arrow at either end.
// -1 on the upper arrow or above the part that is seen, 1 on the lower one or below it, else 0.
int scroll_at(std::size_t tiles, std::size_t chosen, Vec2 const& pixel, Vec2 const& size);

// The tile at a pixel, as the picker lies with that one chosen.
std::optional<std::size_t> tile_at(std::size_t tiles, std::size_t chosen, Vec2 const& pixel, Vec2 const& size);

}  // namespace view
