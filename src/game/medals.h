// Medals: what a game is worth by its time, its pulls and its bananas.
#pragma once

#include "game/game.h"
#include "level/level.h"

namespace game {

enum class Medal { none, bronze, silver, gold };

enum class Met { not_asked, yes, no };
struct Marks {
    Met time = Met::not_asked;
    Met pulls = Met::not_asked;
    Met bananas = Met::not_asked;
};

// How a game that reached the goal stands against what its level asks for: its pars and all of its bananas.
Marks marks_of(level::Level const& level, Status const& status);

// Gold for all that is asked for, silver for all but one, bronze for the goal. None without the goal, nor where nothing
// is asked for.
Medal medal_for(level::Level const& level, Status const& status);

int bananas_in(level::Level const& level);

}  // namespace game
