#include "app/play_game.h"

#include <algorithm>
#include <cmath>

#include "app/output.h"
#include "app/play_save.h"
#include "game/best_times.h"
#include "game/past.h"
#include "game/run_file.h"
#include "view/hud.h"

namespace app {

namespace {

constexpr double toast_length = 4;    // s
constexpr double leaning_time = 0.3;  // s from level to the tilt limit
// A stepping method may be a step ahead of what is shown.
static_assert(game::PastLimits{}.shortest > view::camera_memory + 1 / game::lowest_rate);

void open_session(PlayGame& game, Opened const& opening) {
    note_changed_level(opening);
    note_misspellings(*opening.level);
    game.session = session_for(opening, game.wish);
    game.pace.ticks = 0;
    game.pace.rest = 0;
    game.pace.paused = false;
    game.replay_end.reset();
    if (opening.is_run) game.replay_end = duration_of(opening.run).value();
    game.held.reset();
    game.sent.reset();
    game.looked_at.reset();
    game.noted = opening.is_run;
}

std::optional<int> ball_at(PlayGame const& game, Vec2 const& pixel) {
    Vec2 const point = view::world_of(camera_of(game), pixel);
    level::Level const& level = game.stage->level;
    std::optional<int> found;
    for (int ball = 0; ball < static_cast<int>(level.scene.balls.size()); ++ball) {
        Vec2 const centre = physics::state_at(game.session.history, ball, shown_time(game)).position;
        if (geometry::length(point - centre) > level.scene.balls[static_cast<std::size_t>(ball)].radius) continue;
        if (!found || ball == level.player) found = ball;
    }
    return found;
}

// The player takes over from a run that is being replayed.
void take_over(PlayGame& game) {
    if (!game.replay_end) return;
    game.replay_end.reset();
    // A pull of the run's would hold for ever: nobody is left to let go.
    game::act(game.session, game::Release{});
    say(game, "You play on from here");
}

// Where the pointer that drags a ball is in the world, which depends on where the camera is.
Vec2 pointer_at(PlayGame const& game, double time) {
    view::Camera const camera = view::camera_at(game.stage->level, game.session.history, time, game.size, game.lens);
    return view::world_of(camera, *game.held);
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
    double const limit = game.stage->level.tilt_limit;
    double const now = game.session.world.forces.tilt;
    if (game.replay_end && game.lean == 0) return;
    double const wanted = game.lean * limit;
    if (now == wanted) return;
    take_over(game);
    double const most = limit * simulated / leaning_time;
    game::act(game.session, game::Tilt{now + std::clamp(wanted - now, -most, most)});
}

void note_goal(PlayGame& game) {
    if (game.noted || !game.session.goal_time || *game.session.goal_time > present_time(game)) return;
    game.noted = true;
    try {
        game::Noted const noted = game::note_time(game.stage->level, *game.session.goal_time);
        if (noted.rank == game::Rank::best) say(game, "Best time: " + view::written(*game.session.goal_time, 2) + " s");
        if (noted.set_aside)
            note("smb2d: the list of best times could not be read; it is kept as " + noted.set_aside->string());
    } catch (std::exception const& error) {
        say(game, std::string("The time was not kept: ") + error.what());
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
}

}  // namespace

PlayGame game_of(std::string const& file, game::MethodWish const& wish) {
    PlayGame game;
    game.file = file;
    game.wish = wish;
    Opened const opening = opened(file);
    game.stage = std::make_shared<view::Stage const>(view::stage_of(*opening.level));
    open_session(game, opening);
    return game;
}

void change_to(PlayGame& game, std::string const& file) {
    try {
        PlayGame other = game_of(file, game.wish);
        other.pace.speed = game.pace.speed;
        other.size = game.size;
        other.overlays = game.overlays;
        other.lean = game.lean;
        game = std::move(other);
        game.toast = {};
    } catch (std::exception const& error) {
        say(game, error.what());
        note(std::string("smb2d: ") + error.what());
    }
}

void restart(PlayGame& game) {
    view::Lens const lens = game.lens;
    change_to(game, game.file);
    game.lens = lens;
}

void change_method(PlayGame& game) {
    char const* const names[] = {"article", "euler", "steps", "exact"};
    std::size_t constexpr count = std::size(names);
    std::string const now = physics::name_of(game.session.method);
    std::size_t const at = static_cast<std::size_t>(std::find(names, names + count, now) - names);
    for (std::size_t i = 1; i <= count; ++i) {
        game::MethodWish const wish{names[(at + i) % count], game.wish.rate, game.wish.tolerance};
        if (game::objection_to(wish)) continue;
        game.wish = wish;
        restart(game);
        say(game, std::string("Method: ") + physics::name_of(game.session.method));
        return;
    }
}

view::Camera camera_of(PlayGame const& game) {
    return view::camera_at(game.stage->level, game.session.history, shown_time(game), game.size, game.lens);
}

Pressed press(PlayGame& game, Vec2 const& pixel) {
    std::optional<int> const ball = ball_at(game, pixel);
    if (!ball || return_to_present(game)) return Pressed::nothing;
    take_over(game);
    Vec2 const point = view::world_of(camera_of(game), pixel);
    game::act(game.session, game::Grab{*ball, point});
    game.held = pixel;
    game.sent = point;
    return Pressed::ball;
}

void move_pointer(PlayGame& game, Vec2 const& pixel) {
    if (game.held) game.held = pixel;
}

void release(PlayGame& game) {
    if (!game.held) return;
    send_pointer(game);
    game::act(game.session, game::Release{});
    game.held.reset();
    game.sent.reset();
}

void lose_focus(PlayGame& game) {
    if (!game.held) return;
    release(game);
    say(game, "Let go: the window is no longer in front");
}

bool is_over_ball(PlayGame const& game, Vec2 const& pixel) { return ball_at(game, pixel).has_value(); }

void turn_wheel(PlayGame& game, Vec2 const& pixel, double notches) {
    game.lens = view::zoomed(game.lens, camera_of(game), pixel, notches);
}

void single_step(PlayGame& game) {
    if (game.looked_at) game.looked_at.reset();
    if (!game.pace.paused) return;
    send_pointer(game);
    lean(game, 1.0 / 60);
    double const from = present_time(game);
    game.pace = game::after_single_step(game.pace);
    let_time_pass(game, from);
}

void cycle_overlay(PlayGame& game) {
    view::Overlays const order[] = {
        {}, {true, false, false}, {false, true, false}, {false, false, true}, {true, true, true}};
    char const* const names[] = {"none", "figures", "forces", "energy", "all"};
    std::size_t constexpr count = std::size(order);
    std::size_t const at = static_cast<std::size_t>(std::find(order, order + count, game.overlays) - order);
    std::size_t const next = (at + 1) % count;
    game.overlays = order[next];
    say(game, std::string("Overlay: ") + names[next]);
}

void save_run(PlayGame& game) {
    try {
        std::string const file = free_run_name(game.stage->level.file);
        game::write_run(run_to_save(game.session), file);
        say(game, "Saved " + file);
        note("smb2d: saved " + file);
    } catch (std::exception const& error) {
        say(game, std::string("Not saved: ") + error.what());
        note(std::string("smb2d: not saved: ") + error.what());
    }
}

void say(PlayGame& game, std::string const& text) { game.toast = {text, toast_length}; }

void pass(PlayGame& game, double elapsed) {
    game.toast.left = std::max(0.0, game.toast.left - elapsed);
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
    game.replay_end.reset();
    game.pace.paused = true;
    say(game, "The end of the run; Space plays on from here");
}

}  // namespace app
