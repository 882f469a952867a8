// Which method simulates: the one named, else the one chosen for the scene.
#pragma once

#include <optional>
#include <string>

#include "physics/needs.h"

namespace game {

inline constexpr double lowest_rate = 1;     // steps/s: below it a step is longer than any motion worth a look
inline constexpr double highest_rate = 1e6;  // steps/s: above it a second takes minutes

// How far balls that lean on each other err under `steps` at its usual rate while they move smoothly; the error falls
// with the square of the step. Most of it is the straight line between two steps, which leaves a parabola under gravity
// by g / (8 rate^2). All others, and so a ball alone, are on their exact path at any rate.
inline constexpr double usual_error = 2.5e-5;          // m
inline constexpr double highest_tolerance_rate = 1e5;  // steps/s: no tolerance asks for more

struct MethodWish {
    std::optional<std::string> name;       // "auto", "article", "euler", "steps", "exact"; none = auto
    std::optional<double> rate;            // steps/s; none = the method's own
    std::optional<double> tolerance = {};  // m, the deepest error wanted; none = the method's own
};

// Whether docs/command-line.md knows a method of this name, "auto" included.
bool is_method_name(std::string const& name);

// Why no method of that name can be had, or nothing when it can.
std::optional<std::string> objection_to(MethodWish const& wish);

// The rate for a tolerance, m, under `steps`: its usual one at least, for a few balls that may come to lean on each
// other (for one ball it does not matter); of piles, whose error is that balls sink into each other, what sufficed for
// all that were measured, 60 to 960 steps/s.
double rate_within(double tolerance, physics::Scene const& scene);

// The method named, or the one chosen for the scene by its needs; with a tolerance, `steps` at the rate that keeps it.
// A named rate weighs more than a tolerance. Throws std::runtime_error with the objection, if there is one.
physics::Choice choice_for(MethodWish const& wish, physics::Scene const& scene);
physics::Method method_for(MethodWish const& wish, physics::Scene const& scene);

double rate_of(physics::Method const& method);  // steps/s

}  // namespace game
