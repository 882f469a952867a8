// A world: where everything is at one time and what acts on it; and the history of how it came there. Plain data.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "physics/motion/leg.h"
#include "physics/world/ball_plan.h"
#include "physics/world/scene.h"
#include "physics/world/trail.h"

namespace physics {

// What the player does: the same from one input to the next.
struct Pull {
    int ball = 0;
    Vec2 target = Vec2::Zero();  // m
    bool operator==(Pull const&) const = default;
};
struct Forces {
    double tilt = 0;  // rad, gravity turned counter-clockwise
    std::optional<Pull> pull;
    bool operator==(Forces const&) const = default;
};
Vec2 gravity_of(Scene const& scene, Forces const& forces);

// Of a contact: along the normal and along t = (n.y, -n.x).
struct Impulse {
    double normal = 0;   // N s per kg against terrain, N s between balls
    double tangent = 0;  // the same
};

// What a stepping method keeps from one step to the next. Impulses are those of one substep, in N s: they start the
// next.
struct CachedContact {  // a ball that leans on others, and terrain
    int ball = 0;
    Contact contact;
    Impulse impulse;
};
struct BallPair {  // two balls near each other
    int first = 0, second = 0;
    bool leaning = false;  // they keep in touch, by a soft constraint, until they part
    Impulse impulse;       // while leaning
    Impulse borne;         // when one of them was last put to sleep
};

enum class EventKind {
    land,
    bounce,
    slip,
    grip,
    lift,
    joint,
    corner,
    rest,
    hit,
    grab,
    release,
    tilt,
    sensor,
    handover,
    takeover
};

struct Event {
    double time = 0;
    EventKind kind = EventKind::land;
    int ball = 0;
    State state;      // just after
    Contact contact;  // the surface touched
    int other = -1;   // the other ball of a hit, the sensor of a sensor event, the island of a hand-over or take-over
};

struct World {
    double time = 0;  // s: everything up to here is settled
    Forces forces;
    std::vector<Leg> legs;  // by ball, the current ones

    double step_origin = 0;                      // s, where step 0 began
    long long steps_taken = 0;                   // step n is at step_origin + n / rate
    std::vector<CachedContact> cached_contacts;  // stepping methods, by ball
    std::vector<BallPair> ball_pairs;            // in order of the balls
    std::vector<double> swells;            // by ball: how many times heavier than it is a leaning ball was taken to be
    std::vector<geometry::Box> fat_boxes;  // by ball: while they keep within, there are no other neighbours
    std::vector<int> still_steps;          // by ball, for how many steps it has stood still; apply() clears it
    std::vector<char> in_step;             // by ball: settled to the end of the present step, the others to `time`
    Forces step_forces;                    // that act on those
    std::vector<Event> ahead;              // told of them, but not before their time
    double clear_until = -never;           // s: under step_forces no ball comes near another before

    std::vector<BallPlan> plans;  // of balls on their plan
    double quiet_until = -never;  // s, exact method: no event comes before, as far as is known
    bool handed_over = false;     // the exact method has let `steps` take balls that lean for now:
    std::vector<int> island;      // these and those near them, in order
    double handover_time = 0;     // s, when it first did so

    std::vector<std::vector<bool>> noticed;  // by sensor and ball
};

// How the world came where it is: legs by ball in order of time, the current one last, and events.
struct History {
    std::vector<Trail<Leg>> legs;
    Trail<Event> events;
    std::vector<std::vector<int>> islands;  // the balls of each that was handed over, in order
    double from = 0;                        // s: nothing is known of before
};

// Drops what ended before `time`. Keeps what is needed to answer from `time` on.
void forget_before(History& history, double time);

// The leg among those of one ball that it was on at time t, or the first.
Leg const& leg_at(Trail<Leg> const& legs, double t);

// The leg that a ball was on at time t >= history.from. Where one leg ends as another begins, the later one.
inline Leg const& leg_at(History const& history, int ball, double t) {
    Trail<Leg> const& legs = history.legs[ball];
    return legs.back().since <= t ? legs.back() : leg_at(legs, t);
}

inline State state_at(History const& history, int ball, double t) { return at(leg_at(history, ball, t), t); }

}  // namespace physics
