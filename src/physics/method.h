// The catalogue of methods: each turns a world into the same world later; they are interchangeable.
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "physics/article.h"
#include "physics/euler.h"
#include "physics/exact/exact.h"
#include "physics/steps/steps.h"
#include "physics/world/world.h"

namespace physics {

using Method = std::variant<Article, Euler, Steps, Exact>;

char const* name_of(Method const& method);

// Why a call was refused. The world is then as it was.
struct Fault {
    std::string why;
};

// The world at time 0 and its history, balls at their starts. Sensors that notice a ball there fire at 0.
World world_at_start(Method const& method, Scene const& scene, History& history);

// Advances until world.time >= until and appends legs and events to the history: exactly to `until`, or, with a
// method of steps alone (Article, Euler), to the first step that starts at or after it. Refuses an `until` that is not
// finite; does nothing for one that is past.
std::optional<Fault> advance(Method const& method, Scene const& scene, World& world, double until, History& history);

// From world.time on these forces act. Refuses numbers that are not finite and a ball that does not exist.
std::optional<Fault> apply(Method const& method, Scene const& scene, World& world, Forces const& forces,
                           History& history);

}  // namespace physics
