// Contacts that push at the same moment: the impulses of all of them, found together, so that no order decides.
#pragma once

#include <vector>

#include "geometry/vector.h"

namespace physics {

using geometry::Vec2;

// One contact as the others see it.
struct ContactPush {
    int first = -1, second = 0;  // balls, -1 for terrain; the normal points to the second
    Vec2 normal = Vec2::Zero();  // unit
    double first_yield = 0;      // 1/kg, 0 for terrain
    double second_yield = 0;     // 1/kg
    double wanted = 0;           // by how much the speed, or the distance, along the normal must grow at least
};

// The pushes p >= 0 (N s, or kg m) with which each contact grows by what it wants, and by more only where it does not
// push: p (A p - wanted) = 0, where A p is what they make of the contacts. Direct, so that a mass ratio of 1e6 costs
// no rounds; of contacts that say the same some push and some do not.
std::vector<double> least_pushes(std::vector<ContactPush> const& pushes);

}  // namespace physics
