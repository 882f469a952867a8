// Handing the world over from the exact method to the stepping one, and back.
#pragma once

#include <vector>

#include "physics/world.h"

namespace physics {

// From world.time on the balls take steps, counted from there. States and contacts are kept to the bit.
void hand_over(Scene const& scene, World& world, History& history);

// One step of a world that is handed over.
void step_handed_over(Scene const& scene, World& world, History& history);

// Whether no ball is near another any more or between two surfaces, and the handover has lasted a while.
bool is_apart(Scene const& scene, World const& world);

struct Retaken {
    std::vector<State> states;
    std::vector<Contact> contacts;  // by ball; no_contact in flight
};
// The balls as the exact method takes them: soft contacts leave them a little off their surfaces; they are put on them,
// and what that raises them is taken from their speed, so that no energy is gained.
Retaken taken_back(Scene const& scene, World const& world);

}  // namespace physics
