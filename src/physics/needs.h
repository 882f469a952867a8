// Needs: what a scene asks of a method, and the simplest method that can give it.
#pragma once

#include <string>
#include <vector>

#include "physics/method.h"

namespace physics {

enum class Need { arcs, corners, bounces, slip, resistance, drag, pairs, piles };

struct Reason {
    Need need = Need::arcs;
    std::string why;   // one clause, for people: what in the scene asks for it
    int surface = -1;  // the first surface that does, by Piece::surface: then `why` is what is said of it
};

// Every need once, in the order of Need.
std::vector<Reason> needs_of(Scene const& scene);

char const* name_of(Need need);

// A promise of safety: what the exact method can be trusted with.
bool exact_covers(Need need);

struct Choice {
    Method method;
    std::string why;  // one clause
};
// The first of the methods, the simplest and most exact first, that covers all needs. Never Article or Euler, which
// are kept for comparison alone.
Choice choice_for(Scene const& scene);

}  // namespace physics
