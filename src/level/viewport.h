// Viewports inside a drawing: nested svg elements, symbols, and how their viewBox is fitted.
#pragma once

#include <optional>

#include <pugixml.hpp>

#include "geometry/curve.h"
#include "level/transform.h"

namespace level {

struct Viewport {
    Affine map;                // from inside to the units around it
    Vec2 size = Vec2::Zero();  // inside, what per cent are of
    geometry::Box shown;       // in the units around it, what browsers cut what overflows to
};

// The viewport that `node`, an svg or a symbol, opens within one of the size `around`; a use that refers to it may set
// its width and height. None where it has no extent, so that nothing of it is shown. Throws Broken.
std::optional<Viewport> viewport_of(pugi::xml_node node, pugi::xml_node use, Vec2 const& around);

}  // namespace level
