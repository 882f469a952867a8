// Where a run that was played is saved: a name of its own in the user's data folder.
#pragma once

#include <string>

#include "game/session.h"

namespace app {

// FOLDER/LEVEL-DATE-TIME.json, with a number behind it where that name is taken. Throws std::runtime_error where there
// is no data folder.
std::string free_run_name(std::string const& level_file);

// With the level named so that it is found from wherever the run is.
game::Run run_to_save(game::Session const& session);

}  // namespace app
