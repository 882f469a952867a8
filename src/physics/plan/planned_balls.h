// Balls on their plans: the events of one ball against terrain, whatever becomes of the others.
#pragma once

#include "physics/plan/leg_plan.h"
#include "physics/plan/transition.h"
#include "physics/world/world.h"

namespace physics {

inline constexpr double watch_span = 1e-3;  // s; more events than
inline constexpr int watch_events = 1000;   // these in that span for one of several balls have no end (handover.h)

// A lone ball is never handed over. Bounces on one surface under gravity alone have a limit, to which they are summed,
// after many_events within frame_span from hops of 1/60,000 s on (longest_of_many); others, between two surfaces or in
// a socket, under the pull of the spring or where all but nothing is lost, end where they crowd: after so many of them
// within watch_span, or within frame_span, nothing bounces back. Where more events than stall_events fall in
// stall_span, the ball creeps on (transition.h), and so it does where it changes between contact modes more often than
// flip_events in flip_span, as between two walls as far apart as it is wide; soon after that, after flips_again. It
// also does where blows on several surfaces go on by its spin alone: after most_frame_events in frame_span.
inline constexpr int crowd_events = 50;
inline constexpr double frame_span = 1.0 / 60;  // s
inline constexpr int frame_events = 200;
inline constexpr int most_frame_events = 2 * frame_events;
inline constexpr int many_events = 1000;
inline constexpr double most_summed = 0.9999;  // restitution: above it a sum of bounces counts as endless
inline constexpr double stall_span = 1e-10;    // s
inline constexpr int stall_events = 40;
inline constexpr double flip_span = 1e-4;  // s
inline constexpr int flip_events = 100;
inline constexpr int flips_again = 5;
// More creeps than these within watch_span, and the ball is stopped, to set out from rest; if that jams within
// frame_span as well it stands until the forces change.
inline constexpr int creep_events = 50;

// One call's view of the balls of a world that are on their plans. Legs and events go to the history at world.time.
class PlannedBalls {
public:
    // `alone`: balls go by the rules of one that is alone in its world. What comes more than `horizon` (s) after
    // world.time need not be known.
    PlannedBalls(Scene const& scene, World& world, History& history, bool alone, double horizon = never)
        : scene_(scene), world_(world), history_(history), alone_(alone), horizon_(horizon) {}

    // Sets out from a state at world.time; `known` is the contact that the caller knows to be touched, or no_contact.
    void resolve(int i, State const& state, Contact known);
    // After a hit, whether by another ball or in how it is borne.
    void strike(int i, State const& state);
    // From world.time on moved by world.forces.
    void change_field(int i);
    // The events of one ball up to and including `until` (s).
    void follow(int i, double until);

    enum class Going {
        on,       // the same motion, known further ahead
        changed,  // another leg
        crowded   // no further: its events crowd
    };
    // What follows the end of the ball's leg, which is at world.time.
    Going end_leg(int i);
    // Counts an event of the ball; false when they crowd.
    bool watched(int i);

private:
    MotionContext context(int i) const;
    void tell(EventKind kind, int i, State const& state, Contact contact);
    void take(int i, Transition const& transition);
    Transition after_hit(int i, State const& state) const;
    bool is_elastic(Contact contact) const;
    bool stays_in_touch(int i) const;
    bool stalls(int i);
    bool jams(int i);
    void creep(int i);
    void look_round(int i, BallPlan const& before);
    void set_out(int i, State const& state, Contact contact, double duration, EventKind kind, Contact at_what);
    bool hop(int i);
    bool pass(int i);

    Scene const& scene_;
    World& world_;
    History& history_;
    bool alone_;
    double horizon_;
};

// The same of one ball, as if alone in its world, at a time (s) other than the world's. It sets out from a state, to be
// followed for no longer than `horizon` (s), or, on its plan, is given another by a hit ...
void set_out(Scene const& scene, World& world, History& history, int ball, State const& state, Contact known,
             double time, double horizon = never);
void strike(Scene const& scene, World& world, History& history, int ball, State const& state, double time);
// ... comes to `until` by its events up to then ...
void follow_plan(Scene const& scene, World& world, History& history, int ball, double until);
// ... and is moved by world.forces from `time` on, by others before.
void change_field(Scene const& scene, World& world, History& history, int ball, double time);

// The same of a world of one ball: to `until` (s); and moved by world.forces from world.time on, by `before` before.
void advance_alone(Scene const& scene, World& world, History& history, double until);
void force_alone(Scene const& scene, World& world, History& history, Forces const& before);

}  // namespace physics
