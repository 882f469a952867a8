// Balls that lean on each other: soft constraints, solved a little in each of many substeps (TGS soft, as in Box2D v3).
#pragma once

#include "physics/steps_stage.h"

namespace physics {

// Moves all leaning balls through the substep. The steady overlap of a column is the weight above over
// m_eff (2 pi f)^2, f = min(30 Hz, a quarter of the substep rate), twice that against terrain (physics.md 4).
void move_pile(Stage& stage, Substep const& substep);

}  // namespace physics
