// From a file's name to a session ready to be advanced.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "game/fraction.h"
#include "game/game.h"
#include "game/method_choice.h"
#include "game/session.h"

namespace app {

struct Opened {
    std::string file;  // as the user named it
    std::shared_ptr<level::Level const> level;
    game::Run run;  // of a level: no more than its name
    bool is_run = false;
};

// A level, or a run with its level. Throws std::runtime_error.
Opened opened(std::string const& file);

// Says on standard error when the level is not the one that the run was made for.
void note_changed_level(Opened const& opened);

// Says on standard error which classes are a letter away from a role: what was meant to be a ball is none.
void note_misspellings(level::Level const& level);

// Says on standard error which method is chosen for a tolerance, and why, where none is named; and where the tolerance
// is no more than an estimate.
void note_choice(Opened const& opened, game::MethodWish const& wish);

// What the command line asks for, else what the run was made with, else `auto`. A tolerance is watched where it cannot
// be promised, but not for the window, where what the player will do is not known.
game::Session session_for(Opened const& opened, game::MethodWish const& wish);
game::Session watched_session_for(Opened const& opened, game::MethodWish const& wish);

// Throws std::runtime_error with what was reached where a tolerance that was watched has been missed.
void expect_tolerance_kept(std::string const& file, game::Session const& session);

// The run's duration, else 10 s.
game::Fraction duration_of(game::Run const& run);

}  // namespace app
