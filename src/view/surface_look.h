// What a surface of the ground is seen to be: told by its numbers, so that players see what balls will feel.
#pragma once

#include "physics/terrain/terrain.h"

namespace view {

// The base of its edge, one of four, and whether the edge throws back as well.
enum class Base { grass, ice, mud, tread };
struct SurfaceLook {
    Base base = Base::grass;
    bool bouncy = false;
    bool operator==(SurfaceLook const&) const = default;
};

// Bounds between what levels use: 0.02 to 0.1 is ice, 0.9 the usual; from grip_friction on a ball all but never slips.
inline constexpr double ice_friction = 0.25, grip_friction = 1.5, mud_resistance = 0.03, bouncy_restitution = 0.4;

inline SurfaceLook look_of(physics::Material const& material) {
    SurfaceLook look;
    if (material.friction >= grip_friction) look.base = Base::tread;
    if (material.rolling_resistance >= mud_resistance) look.base = Base::mud;
    if (material.friction <= ice_friction) look.base = Base::ice;
    look.bouncy = material.restitution >= bouncy_restitution;
    return look;
}

}  // namespace view
