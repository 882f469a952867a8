// The regions of a goal: a line, a disc, or any closed shape in convex parts.
#pragma once

#include <string_view>
#include <vector>

#include <pugixml.hpp>

#include "level/transform.h"
#include "physics/world/scene.h"

namespace level {

// None where the shape has no extent. Throws Broken for what cannot be a goal, saying what to do.
std::vector<physics::Region> goal_regions(pugi::xml_node node, std::string_view tag, Affine const& to_world,
                                          Vec2 const& viewport);

}  // namespace level
