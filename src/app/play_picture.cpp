#include <algorithm>
#include <utility>

#include "app/play_game.h"
#include "app/play_menu.h"
#include "game/what_if.h"
#include "view/briefing.h"
#include "view/hud.h"

namespace app {

namespace {

constexpr double toast_fading = 0.6;  // s

std::vector<view::KeyHelp> key_help() {
    return {{"left button", "press on the ball, or near it, and drag it"},
            {"A  D", "tilt the stage; so do the left and right arrows"},
            {"wheel", "zoom"},
            {"Space", "pause; from the past: back to the present"},
            {"comma  period", "hold to look back and forth; Shift: faster"},
            {"in the past", "take the ball, or tilt, to go on from there"},
            {"N", "one step while paused"},
            {"S", "slow motion"},
            {"R", "from the beginning"},
            {"Enter", "after the goal: the next level; after a fall: again"},
            {"L", "all levels, to pick one"},
            {"Tab", "next level; PageDown and PageUp walk through them"},
            {"T", "whether the picture turns as the stage is tilted"},
            {"O", "overlay: figures, forces, energy, all, none"},
            {"M", "mute; minus and plus: volume"},
            {"F3", "next method, from the beginning"},
            {"F5  F6", "save the run; film it while you play on"},
            {"F11", "full screen"},
            {"gamepad", "stick or triggers tilt; Start: menu"},
            {"Esc", "menu: go on, again, levels, sound, quit"}};
}

std::string badge_of(PlayGame const& game) {
    std::string words;
    auto const add = [&](bool is_so, std::string const& word) {
        if (!is_so) return;
        if (!words.empty()) words += ", ";
        words += word;
    };
    if (game.looked_at) return view::written(present_time(game) - *game.looked_at, 2) + " s ago";
    add(game.replay_end.has_value(), "replay");
    add(game.pace.paused, "paused");
    add(game.pace.speed != 1, "slow motion");
    if (game.filmed) add(true, "filming " + view::written(100 * *game.filmed, 0) + " %");
    return words;
}

// What is told of the future must not cost a frame: one step costs microseconds, one ball more as much again.
constexpr std::size_t most_foreseen_balls = 8;
constexpr double foreseen = 1.6;  // s

view::TrajectoryPreview trajectory_preview(PlayGame const& game, view::Premise premise,
                                           physics::History const& coming) {
    physics::Pull const& pull = *game.session.world.forces.pull;
    view::TrajectoryPreview preview =
        view::trajectory_preview(coming, game.stage->level.scene, pull.ball, shown_time(game), foreseen);
    preview.premise = premise;
    return preview;
}

// While the player aims: where the spring takes the ball, and where it flies when it is let go now.
std::vector<view::TrajectoryPreview> coming_of(PlayGame const& game, view::Camera const& camera) {
    if (!game.held || !game.session.world.forces.pull) return {};
    if (game.stage->level.scene.balls.size() > most_foreseen_balls) return {};
    Vec2 const pointer = view::world_of(camera, *game.held);
    return {trajectory_preview(game, view::Premise::held, game::what_if_held(game.session, pointer, foreseen)),
            trajectory_preview(game, view::Premise::let_go, game::what_if(game.session, game::Release{}, foreseen))};
}

view::Moment moment_of(PlayGame const& game, view::Camera const& camera) {
    view::Moment moment = view::moment_of(game.session, shown_time(game), view::recall_for(game.overlays));
    // What the player has just done shows at once, though a stepping method lets it act from the next step on.
    if (!game.looked_at) moment.forces = game.session.world.forces;
    moment.coming = coming_of(game, camera);
    return moment;
}

constexpr double briefing_fading = 0.5;     // s on the wall
constexpr double hand_way = 130;            // pixels of a picture of 1280x720
constexpr double low_ball = 0.7;            // of the height of the picture: a ball so low would lie under the hint
constexpr double lift_over_briefing = 110;  // pixels as above, by which messages stand higher

std::string ending_hint(view::Moment const& moment) {
    return moment.status.goal_time ? "Enter or click: go on    R: again"
                                   : "Enter or click: again    comma, or the bar below: back in time";
}

double briefing_presence(PlayGame const& game) {
    if (game.replay_end || game.file != game.stage->level.file) return 0;
    if (game.waiting) return std::min(1.0, game.wall_time / briefing_fading);
    return 1 - (game.wall_time - game.started_at) / briefing_fading;
}

struct Seen {
    Vec2 centre;    // pixels
    double radius;  // pixels
};
Seen seen_ball(PlayGame const& game, view::Camera const& camera, view::Moment const& moment, int ball) {
    auto const i = static_cast<std::size_t>(ball);
    return {view::pixel_of(camera, moment.balls[i].position), game.stage->level.scene.balls[i].radius * camera.scale};
}

// What the player has yet to learn, shown while the world waits: first the pull, then the tilt.
std::vector<view::Shape> lesson_shapes(PlayGame const& game, view::Camera const& camera, view::Moment const& moment) {
    level::Level const& level = game.stage->level;
    if (!game.waiting || flight_of(game) > 0) return {};
    double const unit = view::hud_scale(game.size);
    if (level.drag_reach > 0 && !game.learnt.contains(game::Lesson::pull)) {
        Seen const ball = seen_ball(game, camera, moment, level.player);
        double const side = ball.centre.x() < game.size.x() / 2 ? 1 : -1;
        return view::pulling_hand_shapes(ball.centre, Vec2(side, -0.45) * hand_way * unit, game.wall_time, unit);
    }
    if (level.tilt_limit > 0 && !game.learnt.contains(game::Lesson::tilt))
        return view::tilting_keys_shapes(game.wall_time, game.size);
    return {};
}

// Where the hint does not lie over the ball that it speaks of.
view::Side side_of_briefing(PlayGame const& game) {
    level::Level const& level = game.stage->level;
    if (!game.waiting && briefing_presence(game) <= 0) return view::Side::lower;
    view::Camera const camera = view::camera_of(game.session, 0, game.size, view::Turning::never, game.lens);
    Vec2 const start = level.scene.balls[static_cast<std::size_t>(level.player)].start.position;
    return view::pixel_of(camera, start).y() > low_ball * game.size.y() ? view::Side::upper : view::Side::lower;
}

// Where the player's ball was at this time in another session, as far as that is known.
std::vector<view::Shape> ghost_shapes(PlayGame const& game, game::Session const& other, view::Camera const& camera) {
    double const time = shown_time(game);
    if (time > other.world.time || time < other.history.from) return {};
    int const player = game.stage->level.player;
    physics::State const ball = physics::state_at(other.history, player, time);
    double const radius = game.stage->level.scene.balls[static_cast<std::size_t>(player)].radius * camera.scale;
    return view::ghost_shapes(view::pixel_of(camera, ball.position), radius, ball.angle - view::turn_of(camera));
}

}  // namespace

view::Picture picture_of(PlayGame const& game, view::Camera const& camera) {
    view::Moment const moment = moment_of(game, camera);
    view::Dressing dressing;
    dressing.overlays = game.overlays;
    dressing.ending = {ending_hint(moment), game.best_before};
    dressing.pointer = game.held ? game.held : game.pointer;
    bool const is_title = game.screen == Screen::title;
    if (is_title) dressing.lettering = view::Lettering::none;
    view::Picture picture = view::picture_of(*game.stage, moment, camera, dressing);
    auto const add = [&](std::vector<view::Shape> more) {
        for (view::Shape& shape : more) picture.shapes.emplace_back(std::move(shape));
    };
    if (is_title) {
        add(view::title_shapes(present_time(game), game.size));
        if (game.help) add(view::help_shapes(key_help(), game.size));
        return picture;
    }
    if (game.ghost) add(ghost_shapes(game, *game.ghost, camera));
    if (game.companion) add(ghost_shapes(game, *game.companion, camera));
    if (game.pointer && !game.held)
        if (auto const ball = ball_at(game, camera, *game.pointer)) {
            Seen const seen = seen_ball(game, camera, moment, *ball);
            add(view::grip_shapes(seen.centre, seen.radius, view::hud_scale(game.size)));
        }
    double const presence = briefing_presence(game);
    view::Side const side = side_of_briefing(game);
    add(view::briefing_shapes(game.stage->level, presence, game.size, side));
    add(lesson_shapes(game, camera, moment));
    std::string const badge = badge_of(game);
    if (!badge.empty()) add(view::badge_shapes(badge, game.size));
    if (shows_timeline(game)) add(view::timeline_shapes(timeline_of(game), game.size));
    bool const in_fault = !game.fault.empty() && game.toast.left <= 0;
    double const lift = presence > 0 && side == view::Side::lower ? lift_over_briefing * view::hud_scale(game.size) : 0;
    add(in_fault ? view::toast_shapes(game.fault, 1, game.size, lift)
                 : view::toast_shapes(game.toast.text, game.toast.left / toast_fading, game.size, lift));
    if (game.menu_row) add(menu_shapes(game));
    if (game.help) add(view::help_shapes(key_help(), game.size));
    return picture;
}

}  // namespace app
