// What the player has been shown and has done: it is kept between games, and not shown again.
#pragma once

#include <set>

namespace game {

enum class Lesson { pull, tilt };

// What is missing or cannot be read counts as nothing learnt yet.
std::set<Lesson> learnt_lessons();

// Throws std::runtime_error where it cannot be kept. A list that cannot be read is set aside before.
void note_learnt(Lesson lesson);

}  // namespace game
