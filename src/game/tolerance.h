// What becomes of a tolerance that cannot be promised: it is said beforehand, and measured while the game runs.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "game/session.h"

namespace game {

std::string in_metres(double length);  // m, in two digits, for people

// Only one ball under `exact`, or under `steps`, where it moves alike to the bit (physics.md 9.1), has no error but
// rounding, whatever happens to it.
bool is_promised(physics::Method const& method, physics::Scene const& scene);

// One clause, for people: why the tolerance is no more than an estimate. Empty where it is promised.
std::string doubt_about(physics::Method const& method, physics::Scene const& scene);

// The error so far. Of a single ball, how far it is from where the exact method has it, at steps and halfway between
// them; of several, whose ways part for any reason, the deepest overlap at the steps.
struct ToleranceWatch {
    double tolerance = 0;               // m
    double until = -physics::never;     // s, measured up to here
    double reached = 0;                 // m
    double reached_at = 0;              // s
    std::optional<double> handed_over;  // s, when balls first came to be stepped
    std::unique_ptr<Session> exact;     // of a single ball, the same game
};

// Measures from now on, if the session's method does not promise the tolerance, m. For inputs that are known
// beforehand: what act() adds is not seen by the exact game beside.
void watch_tolerance(Session& session, double tolerance);

// Up to world.time; advance() calls it.
void measure(ToleranceWatch& watch, Session const& session);

// One clause that says what was reached, where the tolerance was missed.
std::optional<std::string> missed_tolerance(Session const& session);

}  // namespace game
