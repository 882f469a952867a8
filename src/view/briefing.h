// Before the game: the title, what a level is about, and what the player has yet to learn.
#pragma once

#include <string>
#include <vector>

#include "game/texts.h"
#include "level/level.h"
#include "view/camera.h"
#include "view/picture.h"

namespace view {

// Over a level that plays itself; `time` in seconds moves it. `call` says how to start, `keys` what else there is.
std::vector<Shape> title_shapes(double time, Vec2 const& size, std::string const& call, std::string const& keys);

// In which language, and which keys tilt the stage, as the player reads them.
struct Wording {
    game::Language language = game::Language::english;
    std::string left = "←", right = "→";
};

// The level's hint and what is asked for, at an edge of the picture; presence fades it, 1 to 0.
enum class Side { lower, upper };
std::vector<Shape> briefing_shapes(level::Level const& level, double presence, Vec2 const& size,
                                   Side side = Side::lower, Wording const& wording = {});

// A hand that takes hold of the ball at `from` and pulls it along `way`, pixels, again and again.
std::vector<Shape> pulling_hand_shapes(Vec2 const& from, Vec2 const& way, double time, double unit);

// Two keys, pressed in turn, that tilt the stage.
std::vector<Shape> tilting_keys_shapes(double time, Vec2 const& size, Wording const& wording = {});

// Round a ball that a press would take hold of.
std::vector<Shape> grip_shapes(Vec2 const& centre, double radius, double unit);

// Where the ball was in what the player has taken back.
std::vector<Shape> ghost_shapes(Vec2 const& centre, double radius, double angle);

// A text in lines of at most so many letters, broken at spaces.
std::vector<std::string> lines_of(std::string const& text, std::size_t letters);

}  // namespace view
