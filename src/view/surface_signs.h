// The strokes and drops along an edge that tell ice, mud, full grip and rubber apart without colour.
#pragma once

#include <vector>

#include "view/ground.h"
#include "view/polygon.h"
#include "view/surface_look.h"

namespace view {

struct Edge {
    Ring points;             // m
    std::vector<Vec2> into;  // by point, into the ground
    double depth = 0;        // m, of the band along it
};
void add_signs(std::vector<Mark>& marks, Edge const& edge, SurfaceLook const& look);

}  // namespace view
