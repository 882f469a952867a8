// All that one call of the stepping method works on: the balls on their way, and who is near whom. It ends with the
// call.
#pragma once

#include <vector>

#include "physics/steps_travel.h"

namespace physics {

// Two balls that may meet within a step.
struct Encounter {
    int first = 0, second = 0;
    bool leaning = false;  // they keep in touch, by a soft constraint, until they part
    Impulse impulse;       // N s, of the last substep, while leaning
};

// Where a ball's present path began within the substep: at the last impact with another ball, or at the beginning.
struct Departure {
    State state;
    Contact contact;
    double time = 0;  // s into the substep
};

struct Stage {
    explicit Stage(Scene const& of) : scene(of) {}

    Scene const& scene;
    std::vector<Traveller> travellers;
    std::vector<Encounter> encounters;
    std::vector<Departure> departures;
    std::vector<int> order;            // balls from left to right
    std::vector<geometry::Box> known;  // by ball: while it keeps within, the encounters are all it can have
    std::vector<Touch> ground;         // contacts of leaning balls with terrain, with the impulses of the last substep
    std::vector<char> leaning;         // by ball: it leans on another
    std::vector<char> alone;           // by ball: nobody is near, so it needs no substeps
    bool looked_anew = false;  // encounters were found in the middle of a step, without the balls that are alone
    std::vector<char> asleep;  // by ball: it has stood still so long that it is left standing
};

}  // namespace physics
