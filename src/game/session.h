// A session: a level's world under a method, the inputs that steer it, and what the rules make of it. Every way to run
// the game, with a window or without, advances one of these.
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "game/game.h"
#include "level/level.h"
#include "physics/method.h"

namespace game {

struct ForcesSince {
    double time = 0;  // s
    physics::Forces forces;
};

struct ToleranceWatch;  // game/tolerance.h

struct Session {
    std::shared_ptr<level::Level const> level;
    physics::Method method;
    physics::World world;
    physics::History history;
    std::vector<Input> inputs;              // in order of time: those that have acted, then those to come
    std::size_t acted = 0;                  // how many have
    std::vector<double> noticed_at;         // s, by sensor: when it first fired; never = not yet
    std::vector<double> pulled_at;          // s, when the player took a ball
    std::deque<ForcesSince> forces;         // what acted when; the last is what acts now
    std::optional<double> goal_time;        // s, by the rules: the first of these that happens ends the game
    std::optional<double> fall_time;        // s
    std::shared_ptr<ToleranceWatch> watch;  // where a tolerance is to be kept that cannot be promised
};

// Throws std::runtime_error("run: inputs[2]: ...") for a grab of a ball that the level does not have; `run_file` is
// for that message alone.
Session session_of(std::shared_ptr<level::Level const> level, physics::Method const& method,
                   std::vector<Input> inputs = {}, std::string const& run_file = "");

// On to `until`, letting each input act at its time: exactly then, or at the first step that starts at or after it.
// Throws std::runtime_error when the method cannot go on.
void advance(Session& session, double until);

// What the player does now, at world.time; it is recorded, and inputs to come are dropped. A move without a grab and
// a grab of no ball are nothing.
void act(Session& session, Action const& action);

// Where the player's pointer is in the world at a time, m.
using Pointer = std::function<Vec2(double time)>;

// From `from`, up to where it was advanced before, on to `until` while the player holds a ball: as long as the pointer
// is farther from it than the reach, a move at every whole multiple of 1/60 s places the target anew, so that it goes
// along with the ball; one more when it has come within.
void advance_held(Session& session, double from, double until, Pointer const& pointer);

// The same game as it was at a time before world.time, with the inputs up to then and none to come.
Session rewound(Session const& session, double time);

// The same game as much as rules and methods need to go on from here: without past and inputs.
Session without_past(Session const& session);

// Drops legs, events and forces that are not needed to answer from `time` on.
void forget_before(Session& session, double time);

// Which forces acted at a time that is not forgotten.
physics::Forces const& forces_at(Session const& session, double time);

// What the rules say at a time, later events left out.
Status status_at(Session const& session, double time);

// FNV-1a of the state of all balls (docs/runs-and-traces.md), 16 hex digits.
std::string state_hash(std::vector<physics::State> const& balls);
std::string state_hash(Session const& session, double time);

// What has been played up to world.time, ready to be saved.
Run run_of(Session const& session);

}  // namespace game
