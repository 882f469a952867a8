#include "app/play_sound.h"

#include <algorithm>
#include <cmath>
#include <exception>

#include "app/play_settings.h"
#include "sound/hear.h"

namespace app {

namespace {

constexpr int volume_steps = 10;

double gain_of(game::Preferences const& preferences) {
    // Loudness is heard in ratios: a square is near enough.
    return preferences.muted ? 0 : preferences.volume * preferences.volume;
}

bool stands_still(PlayGame const& game) {
    return game.pace.paused || game.looked_at || game.help || game.menu_row || game.settings;
}

}  // namespace

PlaySound::PlaySound() {
    try {
        audio_.emplace(sound::rate, [this](float* samples, int count) { live_.fill(samples, count); });
    } catch (std::exception const&) {
        // Many machines have no device, and nothing depends on it.
    }
}

void PlaySound::follow(PlayGame const& game, double elapsed) {
    if (!audio_) return;
    double const now = present_time(game);
    if (game.stage != stage_ || now < heard_) {
        live_.begin(sound::world_of(*game.stage->level));
        // What happens at the very beginning is heard too.
        heard_ = now > 0 ? now : -1;
    }
    stage_ = game.stage;
    live_.set_volume(gain_of(game.preferences));
    live_.gate(stands_still(game) ? sound::Gate::shut : sound::Gate::open);
    if (now > 0 && !stands_still(game)) live_.hear(game.session, heard_, now, elapsed);
    if (now > 0) heard_ = now;
}

void PlaySound::hush() { live_.gate(sound::Gate::shut); }

void turn_volume(PlayGame& game, int steps) {
    set_volume(game, game.preferences.volume + static_cast<double>(steps) / volume_steps);
}

void set_volume(PlayGame& game, double volume) {
    game.preferences.volume = std::clamp(std::round(volume * volume_steps) / volume_steps, 0.0, 1.0);
    game.preferences.muted = false;
    say(game, game::Text::volume_is, {std::to_string(std::lround(game.preferences.volume * 100))});
    keep_preferences(game);
}

void toggle_mute(PlayGame& game) {
    game.preferences.muted = !game.preferences.muted;
    say(game, game.preferences.muted ? game::Text::muted : game::Text::sound_on);
    keep_preferences(game);
}

}  // namespace app
