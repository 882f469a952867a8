// Balls that lean on each other: soft constraints, solved a little in each of many substeps (TGS soft, as in Box2D v3).
#pragma once

#include "physics/steps/step_context.h"

namespace physics {

// Sets up the bodies and contacts of the island when its pairs and balls are new.
void gather_pile(StepContext& context);

// Moves all leaning balls through the substep. The steady overlap of a column is the weight above over
// m_eff (2 pi f)^2, twice the frequency against terrain (physics.md 9.2). f is a quarter of the substep rate up to
// 60 Hz, an eighth of it where that is more.
void move_pile(StepContext& context, Substep const& substep);

}  // namespace physics
