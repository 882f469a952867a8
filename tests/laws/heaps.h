// Small heaps that nobody thought of: a few balls of any masses in a closed room, dropped, thrown, pulled.
#pragma once

#include <cstdint>

#include "bounds.h"

namespace laws {

struct Tug {
    double time = 0;  // s
    int ball = -1;    // -1 lets go
    Vec2 target = Vec2::Zero();
};

// A room that is symmetric about x = 0, its floor flat or a groove, closed all round.
struct Heap {
    physics::Scene scene;
    std::vector<Tug> tugs;
};

struct HeapKind {
    int most_balls = 6;
    double largest_ratio = 1e6;  // of masses
    bool pulled = false;
};
Heap heap_of(std::uint64_t seed, HeapKind const& kind);

// The same turned over about x = 0.
Heap mirrored(Heap const& heap);

// What was worst at any step of the run, in radii of the (smaller) ball.
struct Worst {
    double overlap = 0;  // of two balls
    double depth = 0;    // of a ball in terrain; more than 1 if its centre got out of the room
    bool finite = true;
};
Worst worst_of(physics::Method const& method, Heap const& heap, double until);

}  // namespace laws
