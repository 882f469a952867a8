// The field a ball moves in: gravity, turned by the tilt, and the drag spring on the ball that is pulled
// (physics.md 3.1).
#pragma once

#include "geometry/oscillator.h"
#include "physics/world/world.h"

namespace physics {

// All that acts on one ball between contacts: gravity, and the drag spring on the ball that is pulled.
struct Field {
    Vec2 gravity = Vec2::Zero();  // m/s^2
    bool pulled = false;
    Vec2 target = Vec2::Zero();  // m
    geometry::Oscillator spring;
};
inline bool is_other(Field const& a, Field const& b) {
    return a.gravity != b.gravity || a.pulled != b.pulled || a.target != b.target;
}
Field field_on(Scene const& scene, Forces const& forces, int ball);

inline Vec2 acceleration_in(Field const& field, Vec2 const& position, Vec2 const& velocity) {
    if (!field.pulled) return field.gravity;
    return field.gravity + field.spring.stiffness * (field.target - position) - (2 * field.spring.decay) * velocity;
}

}  // namespace physics
