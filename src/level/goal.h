// The regions of a goal: a line, a disc, or any closed shape in convex parts.
#pragma once

#include <string_view>
#include <vector>

#include <pugixml.hpp>

#include "level/transform.h"
#include "physics/world/scene.h"

namespace level {

struct GoalRegions {
    std::vector<physics::Region> regions;  // none where the shape has no extent
    std::size_t parted = 0;  // corners of outlines that are not convex: parting takes their square of time
};

// Throws Broken for what cannot be a goal, saying what to do.
GoalRegions goal_regions(pugi::xml_node node, std::string_view tag, Affine const& to_world, Vec2 const& viewport);

}  // namespace level
