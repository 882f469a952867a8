// All that one call of the stepping method works on: the balls on their way, and who is near whom. It ends with the
// call.
#pragma once

#include <vector>

#include "physics/world/force_field.h"
#include "physics/steps/proximity.h"
#include "physics/steps/soft_contact.h"

namespace physics {

// A ball where it has come to in the step.
struct BodyState {
    int index = 0;
    Ball const* ball = nullptr;
    Field const* field = nullptr;
    State state;
    Contact contact;
    Surroundings near;
    bool still = false;  // it stands
};

struct Substep {
    double since = 0;   // s
    double length = 0;  // s
    double end() const { return since + length; }
};

// Where a ball's present path began within the substep: at the last impact with another ball, or at the beginning.
struct Departure {
    State state;
    double time = 0;  // s into the substep
    // Of a ball whose plan changes before the substep ends, so that it can be taken back to it:
    bool keeps_plan = false;  // it does not
    Leg leg;
    BallPlan plan;
    std::size_t legs = 0;  // in its history
};

// Balls that lean on each other, and what the solver works on; anew when they are others.
struct ContactIsland {
    std::vector<int> balls;                      // that lean and are awake, in order
    std::vector<SolverBody> bodies;              // terrain, then one for every ball
    std::vector<int> pairs;                      // neighbours that lean and are not both asleep
    std::vector<SoftContact> contacts;           // one for each of these pairs
    std::vector<SoftContact> ground;             // one for each cached contact
    std::vector<CachedContact> cached_contacts;  // of these balls
    std::vector<CachedContact> left;             // of balls asleep
    std::vector<int> deep;                       // balls pressed too deep into terrain
    std::vector<double> swell;                   // by ball: how many times heavier it is taken to be
};

struct StepContext {
    StepContext(Scene const& of, World& in, History& told) : scene(of), world(in), history(told) {}

    Scene const& scene;
    World& world;
    History& history;
    double pace = 0;            // s, from one substep to the next
    double step = 0;            // s, of its substeps together
    double mass_ratio = 1;      // of the heaviest ball to the lightest
    std::vector<Field> fields;  // that of the balls that are not pulled, then of the one that is
    std::vector<BodyState> body_states;
    std::vector<BallPair> ball_pairs;      // in order of the balls
    std::vector<geometry::Box> fat_boxes;  // by ball: while it keeps within, it has no other neighbours
    std::vector<Departure> departures;
    std::vector<char> leaning;                  // by ball: it leans on another
    std::vector<char> alone;                    // by ball: nobody is near, so it is left on its plan
    std::vector<char> struck;                   // by ball: hit by another in the present pass over the pairs
    std::vector<char> asleep;                   // by ball: it has stood still so long that it is left standing
    std::vector<int> awake;                     // the others that are not alone, in order
    std::vector<int> free;                      // of these, those that do not lean on others
    std::vector<int> live;                      // neighbours of which one is awake
    std::vector<int> pairs_of;                  // the live neighbours of one ball after the other,
    std::vector<int> pairs_from;                // by ball: where its own begin
    std::vector<double> soonest;                // by ball, s: scratch of the search for the next hits, `never` between
    std::vector<int> struck_balls;              // these
    std::vector<int> bunch_balls, bunch_pairs;  // scratch of one hit
    ContactIsland island;
    std::size_t told = 0;      // events before the present substep: none of these is taken back
    int pulled = -1;           // the ball on the drag spring
    bool regroup = true;       // who leans, or who is awake, is not as it was when the groups were made
    bool relist = true;        // likewise of those lists that tell which pairs to look at
    bool looked_anew = false;  // neighbours were found in the middle of a step, without the balls that are alone
    World alone_world;         // in which a stepped ball moves as if it were alone
    History alone_history;
};

}  // namespace physics
