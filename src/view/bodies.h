// Which side of the terrain is earth: outlines made into bodies of ground.
#pragma once

#include <vector>

#include "level/level.h"
#include "view/polygon.h"

namespace view {

// A piece of ground: its edge that balls touch, and the rings that are filled with earth.
struct Body {
    Ring edge;  // m
    Closing closing = Closing::closed;
    std::vector<Vec2> into;   // by point of the edge, into the earth
    std::vector<Ring> rings;  // filled by the even-odd rule; none where the earth is that of another body
    double girth = 1;         // m, how thick the earth is, roughly
};

// Of the terrain that the drawing does not paint itself. Closed outlines are solid, or holes in others, or, with the
// play inside, walls around it. Open ones are filled below where they cross the level like a landscape, else they are
// the upper side of a thin wall.
std::vector<Body> bodies_of(level::Level const& level);

}  // namespace view
