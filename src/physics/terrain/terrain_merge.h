// Merging: terrain as drawn becomes terrain as it is touched, in which curves meet at vertices or cross, and none lies
// on another.
#pragma once

#include <vector>

#include "physics/terrain/terrain.h"

namespace physics {

struct MergedPieces {
    std::vector<Piece> pieces;    // their ends are at the points, to rounding
    std::vector<Vec2> points;     // m, one for every vertex, in lexicographic order
    std::vector<int> start, end;  // by piece, which point; -1 on a whole circle
    geometry::BoxTree tree;       // over the pieces
};

// Three steps, none of which hangs on the order of the pieces:
// - Ends within `vertex_reach` of each other become one place, and so do chains of such ends: of all points of a chain
//   the least by x, then y. Pieces whose ends move keep their shape (lines stay lines, arcs circular); what shrinks to a
//   point is left out, and an arc that comes back to its own beginning is a whole circle.
// - A piece on which a point lies, within `lies_on`, is parted there.
// - Of pieces that lie on each other, within `lies_on`, one stays, with the greatest friction, restitution and rolling
//   resistance of them, and the name of the surface that comes first in the file.
MergedPieces merged(std::vector<Piece> pieces);

inline constexpr double lies_on = 1e-9;  // m, as near as a ball touches

}  // namespace physics
