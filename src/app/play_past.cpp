// Looking back: comma and period move through what the game has kept of its past; the session is never touched.
#include <algorithm>

#include "app/play_game.h"
#include "game/past.h"
#include "game/run_file.h"
#include "view/palette.h"

namespace app {

namespace {

using game::KeyAction;
using game::Text;

constexpr double single_move = 1.0 / 60;  // s, of a key that is pressed for a moment
constexpr double holding_after = 0.25;    // s on the wall: a key that is down for longer is held
constexpr double scrub_speed = 1.5;       // simulated seconds in a second while a key is held
constexpr double fast_factor = 10;

// The camera softly follows a path: what is just before the earliest moment shown must be known to it.
double earliest_shown(PlayGame const& game) {
    double const from = game.session.history.from;
    return from > 0 ? std::min(from + view::camera_memory, present_time(game)) : 0;
}

void look_at(PlayGame& game, double time) {
    if (time >= present_time(game))
        game.looked_at.reset();
    else
        game.looked_at = std::max(time, earliest_shown(game));
}

double factor_of(Hurry hurry) { return hurry == Hurry::fast ? fast_factor : 1; }

}  // namespace

void start_scrub(PlayGame& game, int direction, Hurry hurry) {
    if (game.held) return say(game, Text::let_go_first);
    if (!game.looked_at && direction > 0) return single_step(game);
    if (!game.looked_at && present_time(game) <= earliest_shown(game)) return;
    if (!game.looked_at) {
        game.pace.paused = true;
        say(game, Text::in_the_past,
            {key_of(game, KeyAction::look_back), key_of(game, KeyAction::look_forward),
             key_of(game, KeyAction::pause)});
    }
    look_at(game, shown_time(game) + direction * single_move * factor_of(hurry));
    game.scrub_held = 0;
}

void scrub(PlayGame& game, int direction, Hurry hurry, double elapsed) {
    if (!game.looked_at || direction == 0) return;
    game.scrub_held += elapsed;
    if (game.scrub_held < holding_after) return;
    look_at(game, *game.looked_at + direction * scrub_speed * factor_of(hurry) * elapsed);
    if (!game.looked_at) say(game, Text::at_the_present, {key_of(game, KeyAction::pause)});
}

void look_at_timeline(PlayGame& game, Vec2 const& pixel) {
    view::Timeline const timeline = timeline_of(game);
    game.pace.paused = true;
    look_at(game, view::time_at(timeline, pixel, game.size));
}

bool shows_timeline(PlayGame const& game) {
    return game.looked_at || (game.over_since && game.session.fall_time && game.screen == Screen::game);
}

bool is_on_timeline(PlayGame const& game, Vec2 const& pixel) {
    return shows_timeline(game) && !game.held && view::is_on_timeline(pixel, game.size);
}

void go_on_from_past(PlayGame& game) {
    if (!game.looked_at) return;
    long long const ticks = static_cast<long long>(*game.looked_at * game::ticks_per_second);
    double const time = static_cast<double>(ticks) / game::ticks_per_second;
    game::Status const then = game::status_at(game.session, time);
    if (then.goal_time || then.fall_time || then.out_of_time) return say(game, Text::was_over);
    game::Session earlier = game::rewound(game.session, time);
    game.ghost = std::move(game.session);
    game.session = std::move(earlier);
    game.pace.ticks = ticks;
    game.pace.rest = 0;
    game.pace.paused = false;
    game.looked_at.reset();
    game.replay_end.reset();
    game.over_since.reset();
    game.noted = game::is_run_file(game.file);
    // A pull of what was played: its pointer is not where the player's is now.
    game::act(game.session, game::Release{});
    say(game, Text::on_from_here);
}

bool return_to_present(PlayGame& game) {
    if (!game.looked_at) return false;
    game.looked_at.reset();
    game.pace.paused = false;
    say(game, Text::back_in_present);
    return true;
}

view::Timeline timeline_of(PlayGame const& game) {
    view::Timeline timeline;
    timeline.from = earliest_shown(game);
    timeline.shown = shown_time(game);
    timeline.to = present_time(game);
    using Sign = view::Timeline::Sign;
    auto const mark = [&](double time, view::Colour const& colour, Sign sign) {
        if (time >= timeline.from && time <= timeline.to) timeline.marks.push_back({time, colour, sign});
    };
    game::Session const& session = game.session;
    for (std::size_t i = 0; i < session.noticed_at.size(); ++i)
        if (session.level->meanings[i] == level::Meaning::banana)
            mark(session.noticed_at[i], view::palette::banana, Sign::dot);
    if (session.goal_time) mark(*session.goal_time, view::palette::green, Sign::flag);
    if (session.fall_time) mark(*session.fall_time, view::palette::red, Sign::cross);
    for (std::size_t i = 0; i < session.forces.size(); ++i) {
        if (!session.forces[i].forces.pull) continue;
        double const end = i + 1 < session.forces.size() ? session.forces[i + 1].time : timeline.to;
        auto& pulls = timeline.pulls;
        if (!pulls.empty() && pulls.back().to == session.forces[i].time)
            pulls.back().to = end;
        else if (end > timeline.from)
            pulls.push_back({session.forces[i].time, end});
    }
    return timeline;
}

}  // namespace app
