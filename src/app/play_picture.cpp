#include <algorithm>
#include <utility>

#include "app/play_game.h"
#include "game/glimpse.h"
#include "view/hud.h"

namespace app {

namespace {

constexpr double toast_fading = 0.6;  // s

std::vector<view::KeyHelp> key_help() {
    return {{"left button", "press on the ball and drag it"},
            {"A  D", "tilt the stage; so do the left and right arrows"},
            {"wheel", "zoom"},
            {"Space", "pause; from the past: back to the present"},
            {"comma  period", "hold to look back and forth; Shift: faster"},
            {"N", "one step while paused"},
            {"S", "slow motion"},
            {"R", "from the beginning"},
            {"Tab", "next level; PageDown and PageUp walk through them"},
            {"O", "overlay: figures, forces, energy, all, none"},
            {"M", "next method, from the beginning"},
            {"F5", "save the run"},
            {"F11", "full screen"},
            {"Q  Esc", "quit"}};
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
    return words;
}

// What is told of the future must not cost a frame: one step costs microseconds, one ball more as much again.
constexpr std::size_t most_foreseen_balls = 8;
constexpr double foreseen = 1.6;  // s

view::Foresight foresight_of(PlayGame const& game, view::Premise premise, physics::History const& coming) {
    physics::Pull const& pull = *game.session.world.forces.pull;
    view::Foresight foresight =
        view::foresight_of(coming, game.stage->level.scene, pull.ball, shown_time(game), foreseen);
    foresight.premise = premise;
    return foresight;
}

// While the player aims: where the spring takes the ball, and where it flies when it is let go now.
std::vector<view::Foresight> coming_of(PlayGame const& game) {
    if (!game.held || !game.session.world.forces.pull) return {};
    if (game.stage->level.scene.balls.size() > most_foreseen_balls) return {};
    Vec2 const pointer = view::world_of(camera_of(game), *game.held);
    return {foresight_of(game, view::Premise::held, game::glimpse_held(game.session, pointer, foreseen)),
            foresight_of(game, view::Premise::let_go, game::glimpse(game.session, game::Release{}, foreseen))};
}

view::Moment moment_of(PlayGame const& game) {
    view::Moment moment = view::moment_of(game.session, shown_time(game), view::recall_for(game.overlays));
    // What the player has just done shows at once, though a stepping method lets it act from the next step on.
    if (!game.looked_at) moment.forces = game.session.world.forces;
    moment.coming = coming_of(game);
    return moment;
}

}  // namespace

view::Picture picture_of(PlayGame const& game) {
    view::Moment const moment = moment_of(game);
    view::Dressing dressing;
    dressing.overlays = game.overlays;
    dressing.hint = moment.status.goal_time ? "Tab: next level   R: again" : "R: try again";
    view::Picture picture = view::picture_of(*game.stage, moment, camera_of(game), dressing);
    auto const add = [&](std::vector<view::Shape> more) {
        for (view::Shape& shape : more) picture.shapes.emplace_back(std::move(shape));
    };
    std::string const badge = badge_of(game);
    if (!badge.empty()) add(view::badge_shapes(badge, game.size));
    if (game.looked_at) add(view::timeline_shapes(timeline_of(game), game.size));
    bool const in_fault = !game.fault.empty() && game.toast.left <= 0;
    add(in_fault ? view::toast_shapes(game.fault, 1, game.size)
                 : view::toast_shapes(game.toast.text, game.toast.left / toast_fading, game.size));
    if (game.help) add(view::help_shapes(key_help(), game.size));
    return picture;
}

}  // namespace app
