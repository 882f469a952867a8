#include "physics/world/force_field.h"

#include "geometry/elementary.h"

namespace physics {

Field field_on(Scene const& scene, Forces const& forces, int ball) {
    Field field;
    field.gravity = gravity_of(scene, forces);
    if (!forces.pull || forces.pull->ball != ball || scene.drag.frequency <= 0) return field;
    double const omega = 2 * geometry::pi * scene.drag.frequency;
    field.pulled = true;
    field.target = forces.pull->target;
    field.spring = {scene.drag.damping * omega, omega * omega};
    return field;
}

}  // namespace physics
