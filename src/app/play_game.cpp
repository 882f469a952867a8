#include "app/play_game.h"

#include <algorithm>
#include <cmath>

#include "app/output.h"
#include "app/play_save.h"
#include "game/best_times.h"
#include "game/medals.h"
#include "game/past.h"
#include "game/run_file.h"
#include "view/hud.h"

namespace app {

using game::Text;

namespace {

constexpr double toast_length = 4;    // s
constexpr double leaning_time = 0.3;  // s from level to the tilt limit
constexpr double near_ball = 2;       // radii: a press so near takes hold of it
constexpr double near_small = 22;     // pixels of a picture of 1280x720: the same for a ball that looks small
constexpr double card_time = 0.6;     // s on the wall, before a press closes a card
constexpr double falling_time = 1.5;  // s on the wall: so long after a fall the world stands still,
constexpr double rolling_on = 4;      // and after the goal
// A stepping method may be a step ahead of what is shown.
static_assert(game::PastLimits{}.shortest > view::camera_memory + 1 / game::lowest_rate);

// The player takes over from a run that is being replayed.
void take_over(PlayGame& game) {
    if (!game.replay_end) return;
    game.replay_end.reset();
    // A pull of the run's would hold for ever: nobody is left to let go.
    game::act(game.session, game::Release{});
    say(game, Text::played_on);
}

void learn(PlayGame& game, game::Lesson lesson) {
    if (!game.learnt.insert(lesson).second) return;
    try {
        game::note_learnt(lesson);
    } catch (std::exception const& error) {
        note(std::string("smb2d: ") + error.what());
    }
}

// After the goal the ball rolls on for a while; after a fall, or when the time is over, there is nothing more to come.
bool has_come_to_an_end(PlayGame const& game) {
    if (!game.over_since || game.replay_end) return false;
    return game.wall_time - *game.over_since > (game.session.goal_time ? rolling_on : falling_time);
}

// Where the pointer that drags a ball is in the world, which depends on where the camera is.
Vec2 pointer_at(PlayGame const& game, double time) {
    return view::world_of(view::camera_of(game.session, time, game.size, turning_of(game), lens_of(game)), *game.held);
}

// Tells the session where the pointer is in the world now, be it because the camera has moved.
void send_pointer(PlayGame& game) {
    if (!game.held) return;
    Vec2 const point = pointer_at(game, present_time(game));
    if (game.sent && *game.sent == point) return;
    game::act(game.session, game::Move{point});
    game.sent = point;
}

void lean(PlayGame& game, double simulated) {
    double const limit = game.stage->level->tilt_limit;
    double const now = game.session.world.forces.tilt;
    double const leaning = leaning_of(game);
    if (game.replay_end && (leaning == 0 || game.screen == Screen::title)) return;
    double const wanted = is_over(game) ? 0 : leaning * limit;
    if (now == wanted) return;
    take_over(game);
    learn(game, game::Lesson::tilt);
    double const most = limit * simulated / leaning_time;
    game::act(game.session, game::Tilt{now + std::clamp(wanted - now, -most, most)});
}

void note_set_aside(std::optional<std::filesystem::path> const& aside, char const* what) {
    if (aside) note(std::string("smb2d: the list of ") + what + " could not be read; it is kept as " + aside->string());
}

void note_goal(PlayGame& game) {
    if (game.noted || !game.session.goal_time || *game.session.goal_time > present_time(game)) return;
    game.noted = true;
    level::Level const& level = *game.stage->level;
    double const time = *game.session.goal_time;
    try {
        note_set_aside(game::note_time(level, time).set_aside, "best times");
        note_set_aside(game::note_medal(level, game::medal_for(level, game::status_at(game.session, time))), "medals");
    } catch (std::exception const& error) {
        say(game, Text::time_not_kept, {error.what()});
        note(std::string("smb2d: ") + error.what());
    }
}

// From the time that was shown before up to the one that the pace shows.
void let_time_pass(PlayGame& game, double from) {
    double const now = present_time(game);
    if (game.held)
        game::advance_held(game.session, from, now, [&](double time) { return pointer_at(game, time); });
    else
        game::advance(game.session, now);
    game::keep_past(game.session, present_time(game));
    note_goal(game);
    if (!is_over(game)) return;
    if (!game.over_since) game.over_since = game.wall_time;
    if (!game.replay_end) release(game);
}

}  // namespace

double flight_of(PlayGame const& game) {
    if (!game.waiting || game.preferences.reduced_motion) return 0;
    double const share = std::clamp(1 - game.wall_time / flight_time, 0.0, 1.0);
    return share * share * (3 - 2 * share);
}

view::Camera camera_of(PlayGame const& game) {
    view::Camera const camera =
        view::camera_of(game.session, shown_time(game), game.size, turning_of(game), lens_of(game));
    return view::towards_goal(*game.stage->level, camera, flight_of(game));
}

bool is_over(PlayGame const& game) {
    game::Status const status = game::status_at(game.session, present_time(game));
    return status.goal_time || status.fall_time || status.out_of_time;
}

bool is_card_open(PlayGame const& game) {
    return game.over_since && !game.looked_at && game.wall_time - *game.over_since > card_time;
}

void begin(PlayGame& game) {
    if (!game.waiting) return;
    game.waiting = false;
    game.started_at = game.wall_time;
}

std::optional<int> ball_at(PlayGame const& game, view::Camera const& camera, Vec2 const& pixel) {
    level::Level const& level = *game.stage->level;
    if (level.drag_reach <= 0 || game.screen == Screen::title) return std::nullopt;
    if (!game.looked_at && is_over(game)) return std::nullopt;
    Vec2 const point = view::world_of(camera, pixel);
    double const small = near_small * view::hud_scale(game.size) / camera.scale;  // m
    std::optional<int> found;
    double nearest = 1;  // of how far off a press may be
    for (int ball = 0; ball < static_cast<int>(level.scene.balls.size()); ++ball) {
        Vec2 const centre = physics::state_at(game.session.history, ball, shown_time(game)).position;
        double const reach = std::max(near_ball * level.scene.balls[static_cast<std::size_t>(ball)].radius, small);
        double const share = geometry::length(point - centre) / reach;
        if (share > nearest || (share == nearest && ball != level.player)) continue;
        found = ball;
        nearest = share;
    }
    return found;
}

Pressed press(PlayGame& game, Vec2 const& pixel) {
    if (is_on_timeline(game, pixel)) {
        game.on_timeline = true;
        move_pointer(game, pixel);
        return Pressed::timeline;
    }
    if (game.waiting) game.wall_time = std::max(game.wall_time, flight_time);
    std::optional<int> const ball = ball_at(game, camera_of(game), pixel);
    if (!ball) return Pressed::nothing;
    go_on_from_past(game);
    if (game.looked_at) return Pressed::nothing;
    begin(game);
    take_over(game);
    learn(game, game::Lesson::pull);
    Vec2 const point = view::world_of(camera_of(game), pixel);
    game::act(game.session, game::Grab{*ball, point});
    game.held = pixel;
    game.sent = point;
    return Pressed::ball;
}

void move_pointer(PlayGame& game, Vec2 const& pixel) {
    game.pointer = pixel;
    if (game.on_timeline) look_at_timeline(game, pixel);
    if (!game.held) return;
    game.held = pixel;
    if (game.pace.paused) send_pointer(game);
}

void release(PlayGame& game) {
    game.on_timeline = false;
    if (!game.held) return;
    send_pointer(game);
    game::act(game.session, game::Release{});
    game.held.reset();
    game.sent.reset();
}

void lose_focus(PlayGame& game) {
    release(game);
    bool const stands = game.waiting || game.pace.paused || game.menu_row || game.settings || game.help;
    if (stands || game.screen == Screen::title || game.replay_end || is_over(game)) return;
    game.pace.paused = true;
    say(game, Text::focus_lost, {key_of(game, game::KeyAction::pause)});
}

void turn_wheel(PlayGame& game, Vec2 const& pixel, double notches) {
    game.lens = view::zoomed(game.lens, camera_of(game), pixel, notches);
}

void single_step(PlayGame& game) {
    if (game.looked_at) game.looked_at.reset();
    if (!game.pace.paused || game.waiting) return;
    send_pointer(game);
    lean(game, 1.0 / 60);
    double const from = present_time(game);
    game.pace = game::after_single_step(game.pace);
    let_time_pass(game, from);
}

void cycle_overlay(PlayGame& game) {
    view::Overlays const order[] = {
        {}, {true, false, false}, {false, true, false}, {false, false, true}, {true, true, true}};
    Text const names[] = {Text::overlay_none, Text::overlay_figures, Text::overlay_forces, Text::overlay_energy,
                          Text::overlay_all};
    std::size_t constexpr count = std::size(order);
    std::size_t const at = static_cast<std::size_t>(std::find(order, order + count, game.overlays) - order);
    std::size_t const next = (at + 1) % count;
    game.overlays = order[next];
    say(game, Text::overlay_is, {game::words(names[next], language_of(game))});
}

std::optional<std::string> save_run(PlayGame& game) {
    try {
        std::string const file = free_run_name(game.stage->level->file);
        game::write_run(run_to_save(game.session), file);
        say(game, Text::saved, {file});
        note("smb2d: saved " + file);
        return file;
    } catch (std::exception const& error) {
        say(game, Text::not_saved, {error.what()});
        note(std::string("smb2d: not saved: ") + error.what());
        return std::nullopt;
    }
}

void say(PlayGame& game, std::string const& text) { game.toast = {text, toast_length}; }

void say(PlayGame& game, Text text, std::initializer_list<std::string> values) {
    say(game, game::words(text, language_of(game), values));
}

void let_toast_fade(PlayGame& game, double elapsed) { game.toast.left = std::max(0.0, game.toast.left - elapsed); }

void pass(PlayGame& game, double elapsed) {
    let_toast_fade(game, elapsed);
    game.wall_time += elapsed;
    if (game.help || game.menu_row || game.settings) return;
    game.lean_is_old = game.lean_is_old && leaning_of(game) != 0;
    bool const tilts =
        leaning_of(game) != 0 && !game.lean_is_old && game.stage->level->tilt_limit > 0 && game.screen == Screen::game;
    if (tilts && game.looked_at) go_on_from_past(game);
    if (tilts) begin(game);
    if (game.waiting || has_come_to_an_end(game)) return;
    long long const before = game.pace.ticks;
    game::Pace const next = game::after(game.pace, elapsed);
    if (next.ticks == before) {
        game.pace = next;
        return;
    }
    double const simulated = static_cast<double>(next.ticks - before) / game::ticks_per_second;
    send_pointer(game);
    lean(game, simulated);
    double const from = present_time(game);
    game.pace = next;
    let_time_pass(game, from);
    if (!game.replay_end || present_time(game) < *game.replay_end) return;
    if (game.screen == Screen::title) return restart(game);
    game.replay_end.reset();
    game.pace.paused = true;
    say(game, Text::run_ends, {key_of(game, game::KeyAction::pause)});
}

}  // namespace app
