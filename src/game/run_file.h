// Run files: a level and what the player did, as JSON (docs/runs-and-traces.md).
#pragma once

#include <string>

#include "game/game.h"

namespace game {

// Throws std::runtime_error("file: inputs[3]: what") for the first error. Whether the balls it grabs exist is seen
// only with the level at hand.
Run read_run(std::string const& file);

// The text of a run file that stands in `folder`: the level is named relative to it.
std::string text_of(Run const& run, std::string const& folder);

// Whole or not at all. Throws std::runtime_error.
void write_run(Run const& run, std::string const& file);

// Whether the file is a run rather than a level: by its name, else by its first letter. False where it cannot be read.
bool is_run_file(std::string const& file);

}  // namespace game
