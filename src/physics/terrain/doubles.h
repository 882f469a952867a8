// Pieces that are drawn more than once.
#pragma once

#include "physics/terrain/terrain_merge.h"

namespace physics {

// Of pieces that lie on each other, within `lies_on`, leaves the one that comes first in the file, with the greatest
// friction, restitution and rolling resistance of them. Whether any piece was left out; the tree stays as it was.
bool leave_out_doubles(MergedPieces& all);

}  // namespace physics
