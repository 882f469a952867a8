// All that one call of the stepping method works on: the balls on their way, and who is near whom. It ends with the
// call.
#pragma once

#include <vector>

#include "physics/steps_soft.h"
#include "physics/steps_travel.h"

namespace physics {

// Where a ball's present path began within the substep: at the last impact with another ball, or at the beginning.
struct Departure {
    State state;
    Contact contact;
    double time = 0;  // s into the substep
};

// Balls that lean on each other, and what the solver works on; anew when they are others.
struct Pile {
    std::vector<int> balls;             // that lean and are awake, in order
    std::vector<Body> bodies;           // terrain, then one for every ball
    std::vector<int> pairs;             // neighbours that lean and are not both asleep
    std::vector<SoftContact> contacts;  // one for each of these pairs
    std::vector<SoftContact> ground;    // one for each touch
    std::vector<Touch> touches;         // of these balls
    std::vector<Touch> left;            // of balls asleep
};

struct Stage {
    explicit Stage(Scene const& of) : scene(of) {}

    Scene const& scene;
    std::vector<Field> fields;  // that of the balls that are not pulled, then of the one that is
    std::vector<Traveller> travellers;
    std::vector<Neighbours> neighbours;  // in order of the balls
    std::vector<geometry::Box> reaches;  // by ball: while it keeps within, it has no other neighbours
    std::vector<Departure> departures;
    std::vector<char> leaning;  // by ball: it leans on another
    std::vector<char> alone;    // by ball: nobody is near, so it needs no substeps
    std::vector<char> struck;   // by ball: hit by another in the present pass over the pairs
    std::vector<char> asleep;   // by ball: it has stood still so long that it is left standing
    std::vector<int> awake;     // the others that are not alone, in order
    std::vector<int> free;      // of these, those that do not lean on others
    std::vector<int> live;      // neighbours of which one is awake
    Pile pile;
    int pulled = -1;           // the ball on the drag spring
    bool regroup = true;       // who leans, or who is awake, is not as it was when the groups were made
    bool relist = true;        // likewise of those lists that tell which pairs to look at
    bool looked_anew = false;  // neighbours were found in the middle of a step, without the balls that are alone
};

}  // namespace physics
