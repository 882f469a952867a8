// Where the balls start: how deep they overlap terrain and each other, and how slight overlaps are undone.
#pragma once

#include <vector>

#include "physics/world/scene.h"

namespace level {

inline constexpr double touching = 1e-9;        // m, docs/levels.md: nearer than this is contact, not overlap
inline constexpr double slight_overlap = 0.05;  // of the radius, the smaller one of two balls

struct Overlap {
    int ball = 0;
    int other = -1;    // the other ball, before it in the file; -1 = terrain
    double depth = 0;  // m
    bool slight = true;
};

// Overlaps deeper than `touching`: the deepest with terrain by ball, then those between balls; not all of them where
// very many are more than slight.
std::vector<Overlap> overlaps_in(physics::Scene const& scene);

// The balls moved out along the normals, a little at a time where several surfaces press, until they touch.
// `overlaps` are those of the scene, all of them slight. Where a ball does not fit, overlaps remain.
std::vector<physics::Ball> moved_out(physics::Scene const& scene, std::vector<Overlap> const& overlaps);

}  // namespace level
