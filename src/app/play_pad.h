// Gamepads: which are there, and what their sticks, triggers and buttons mean.
#pragma once

#include <SDL.h>

#include <map>
#include <memory>
#include <optional>

#include "app/play_actions.h"

namespace app {

// Where a button is pressed: what it means hangs on it.
enum class Place { title, waiting, game, card, picker, menu, settings };

// What the button means there; nothing where it means nothing.
std::optional<Press> press_for(SDL_GameControllerButton button, Place place);

struct Sticks {
    double x = 0;                // of the left stick, in [-1, 1], right positive
    double left = 0, right = 0;  // triggers, in [0, 1]
    int cross = 0;               // -1, 0, 1
};
// How far to lean, in [-1, 1], right positive: what is pushed furthest. Little is nothing, for sticks do not come back
// to their middle, and the rest goes in steps, so that a hand that holds still makes no inputs.
double lean_of(Sticks const& sticks);

// Those that are plugged in. Nothing where SDL knows none.
class Pads {
public:
    Pads();
    ~Pads();
    Pads(Pads const&) = delete;
    Pads& operator=(Pads const&) = delete;

    enum class News { nothing, came, went };
    News listen(SDL_Event const& event);

    // Of the pad that leans furthest.
    double lean() const;

private:
    struct Close {
        void operator()(SDL_GameController* pad) const { SDL_GameControllerClose(pad); }
    };
    bool started_ = false;
    std::map<SDL_JoystickID, std::unique_ptr<SDL_GameController, Close>> open_;
};

}  // namespace app
