// What is heard in the window: the game's own sound, where there is a device.
#pragma once

#include <memory>
#include <optional>

#include "app/play_game.h"
#include "screen/audio.h"
#include "sound/live.h"

namespace app {

class PlaySound {
public:
    // Opens the device; without one the game goes on in silence.
    PlaySound();
    explicit PlaySound(std::nullopt_t) {}  // silence

    // `elapsed` seconds have passed on the wall. Silent while the game stands still.
    void follow(PlayGame const& game, double elapsed);
    void hush();

private:
    sound::Live live_;
    std::optional<screen::Audio> audio_;  // asks live_: gone before it
    std::shared_ptr<view::Stage const> stage_;
    double heard_ = 0;  // s, of the game
};

// Louder or softer by one step, and remembered; in a toast.
void turn_volume(PlayGame& game, int steps);
void set_volume(PlayGame& game, double volume);  // to the nearest step of [0, 1]
void toggle_mute(PlayGame& game);

}  // namespace app
