#include <algorithm>
#include <utility>

#include "app/play_screens.h"
#include "app/play_settings.h"
#include "game/run_file.h"
#include "game/what_if.h"
#include "view/briefing.h"
#include "view/hud.h"
#include "view/settings_page.h"

namespace app {

namespace {

using game::KeyAction;
using game::Text;

constexpr double toast_fading = 0.6;  // s

std::vector<view::Shape> help_shapes(PlayGame const& game) {
    game::Language const language = language_of(game);
    return view::help_shapes(game::words(Text::help_title, language), view::key_help(game.bindings, language),
                             game.size);
}

std::string badge_of(PlayGame const& game) {
    std::string words;
    auto const add = [&](bool is_so, std::string const& word) {
        if (!is_so) return;
        if (!words.empty()) words += ", ";
        words += word;
    };
    game::Language const language = language_of(game);
    if (game.looked_at)
        return game::words(Text::badge_ago, language, {view::written(present_time(game) - *game.looked_at, 2)});
    add(game.replay_end.has_value(), game::words(Text::badge_replay, language));
    add(game.pace.paused, game::words(Text::badge_paused, language));
    add(game.pace.speed != 1, game::words(Text::badge_slow, language));
    if (game.filmed) add(true, game::words(Text::badge_filming, language, {view::written(100 * *game.filmed, 0)}));
    return words;
}

// What is told of the future must not cost a frame: one step costs microseconds, one ball more as much again.
constexpr std::size_t most_foreseen_balls = 8;
constexpr double foreseen = 1.6;  // s

view::TrajectoryPreview trajectory_preview(PlayGame const& game, view::Premise premise,
                                           physics::History const& coming) {
    physics::Pull const& pull = *game.session.world.forces.pull;
    view::TrajectoryPreview preview =
        view::trajectory_preview(coming, game.stage->level->scene, pull.ball, shown_time(game), foreseen);
    preview.premise = premise;
    return preview;
}

// While the player aims: where the spring takes the ball, and where it flies when it is let go now.
std::vector<view::TrajectoryPreview> coming_of(PlayGame const& game, view::Camera const& camera) {
    if (!game.held || !game.session.world.forces.pull) return {};
    if (game.stage->level->scene.balls.size() > most_foreseen_balls) return {};
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

std::string ending_hint(PlayGame const& game, view::Moment const& moment) {
    bool const won = moment.status.goal_time.has_value();
    game::KeyAction const other = won ? game::KeyAction::restart : game::KeyAction::look_back;
    return game::words(won ? Text::goal_hint : Text::fall_hint, language_of(game),
                       {key_of(game, game::KeyAction::go_on), key_of(game, other)});
}

view::EndingNote ending_note(PlayGame const& game, view::Moment const& moment) {
    view::EndingNote note{ending_hint(game, moment), game.best_before, language_of(game), motion_of(game), {}};
    // A film of a replay would be one of what is a file already.
    if (!game.filmed && !game::is_run_file(game.file))
        note.film = game::words(Text::film_button, language_of(game)) + "  " + key_of(game, KeyAction::film);
    return note;
}

view::Contrast contrast_of(PlayGame const& game) {
    return game.preferences.high_contrast ? view::Contrast::high : view::Contrast::usual;
}

// What is written over a scene.
void add_written(PlayGame const& game, view::Picture& picture, std::vector<view::Shape> more) {
    if (contrast_of(game) == view::Contrast::high) more = view::in_high_contrast(std::move(more));
    for (view::Shape& shape : more) picture.shapes.emplace_back(std::move(shape));
}

// A page or the menu takes the place of what is told of the level.
bool is_covered(PlayGame const& game) { return game.menu_row || game.settings || game.help; }

double briefing_presence(PlayGame const& game) {
    if (is_covered(game)) return 0;
    if (game.replay_end || game.file != game.stage->level->file) return 0;
    if (game.waiting) return std::min(1.0, game.wall_time / briefing_fading);
    return 1 - (game.wall_time - game.started_at) / briefing_fading;
}

view::Wording wording_of(PlayGame const& game) {
    return {language_of(game), key_of(game, KeyAction::tilt_left), key_of(game, KeyAction::tilt_right)};
}

struct Seen {
    Vec2 centre;    // pixels
    double radius;  // pixels
};
Seen seen_ball(PlayGame const& game, view::Camera const& camera, view::Moment const& moment, int ball) {
    auto const i = static_cast<std::size_t>(ball);
    return {view::pixel_of(camera, moment.balls[i].position), game.stage->level->scene.balls[i].radius * camera.scale};
}

// What the player has yet to learn, shown while the world waits: first the pull, then the tilt.
std::vector<view::Shape> lesson_shapes(PlayGame const& game, view::Camera const& camera, view::Moment const& moment) {
    level::Level const& level = *game.stage->level;
    if (!game.waiting || is_covered(game) || flight_of(game) > 0) return {};
    double const unit = view::hud_scale(game.size);
    if (level.drag_reach > 0 && !game.learnt.contains(game::Lesson::pull)) {
        Seen const ball = seen_ball(game, camera, moment, level.player);
        double const side = ball.centre.x() < game.size.x() / 2 ? 1 : -1;
        return view::pulling_hand_shapes(ball.centre, Vec2(side, -0.45) * hand_way * unit, game.wall_time, unit);
    }
    if (level.tilt_limit > 0 && !game.learnt.contains(game::Lesson::tilt))
        return view::tilting_keys_shapes(game.wall_time, game.size, wording_of(game));
    return {};
}

// Where the hint does not lie over the ball that it speaks of.
view::Side side_of_briefing(PlayGame const& game) {
    level::Level const& level = *game.stage->level;
    if (!game.waiting && briefing_presence(game) <= 0) return view::Side::lower;
    view::Camera const camera = view::camera_of(game.session, 0, game.size, view::Turning::never, lens_of(game));
    Vec2 const start = level.scene.balls[static_cast<std::size_t>(level.player)].start.position;
    return view::pixel_of(camera, start).y() > low_ball * game.size.y() ? view::Side::upper : view::Side::lower;
}

// Where the player's ball was at this time in another session, as far as that is known.
std::vector<view::Shape> ghost_of(PlayGame const& game, game::Session const& other, view::Camera const& camera) {
    double const time = shown_time(game);
    if (time > other.world.time || time < other.history.from) return {};
    int const player = game.stage->level->player;
    physics::State const ball = physics::state_at(other.history, player, time);
    double const radius = game.stage->level->scene.balls[static_cast<std::size_t>(player)].radius * camera.scale;
    return view::ghost_shapes(view::pixel_of(camera, ball.position), radius, ball.angle - view::turn_of(camera));
}

std::vector<view::Shape> ghosts_of(PlayGame const& game, view::Camera const& camera) {
    std::vector<view::Shape> shapes;
    if (game.ghost) shapes = ghost_of(game, *game.ghost, camera);
    if (!game.companion) return shapes;
    for (view::Shape& shape : ghost_of(game, *game.companion, camera)) shapes.emplace_back(std::move(shape));
    return shapes;
}

// What lies over any screen: settings, help, and a message, or the fault that stands in its place.
std::vector<view::Shape> cover_shapes(PlayGame const& game, std::string const& fault = {}, double lift = 0) {
    std::vector<view::Shape> shapes;
    auto const add = [&](std::vector<view::Shape> more) {
        for (view::Shape& shape : more) shapes.emplace_back(std::move(shape));
    };
    if (game.settings) add(settings_shapes(game));
    if (game.help) add(help_shapes(game));
    if (game.settings && fault.empty()) return shapes;  // its page tells messages
    if (game.help) lift = view::lift_over_help(game.size);
    add(fault.empty() ? view::toast_shapes(game.toast.text, game.toast.left / toast_fading, game.size, lift)
                      : view::toast_shapes(fault, 1, game.size, lift));
    return shapes;
}

}  // namespace

view::Picture picture_of(PlayGame const& game, view::Camera const& camera) {
    view::Moment const moment = moment_of(game, camera);
    view::Dressing dressing;
    dressing.overlays = game.overlays;
    dressing.ending = ending_note(game, moment);
    dressing.motion = motion_of(game);
    dressing.contrast = contrast_of(game);
    dressing.pointer = game.held ? game.held : game.pointer;
    bool const is_title = game.screen == Screen::title;
    game::Language const language = language_of(game);
    if (is_title)
        dressing.lettering = view::Lettering::none;
    else
        dressing.ghosts = ghosts_of(game, camera);
    if (!is_title && is_covered(game)) dressing.lettering = view::Lettering::heading;
    view::Picture picture = view::picture_of(*game.stage, moment, camera, dressing);
    auto const add = [&](std::vector<view::Shape> more) { add_written(game, picture, std::move(more)); };
    if (is_title) {
        add(view::title_shapes(game.preferences.reduced_motion ? 0 : present_time(game), game.size,
                               game::words(Text::title_start, language),
                               game::words(Text::title_keys, language,
                                           {key_of(game, KeyAction::levels), key_of(game, KeyAction::help),
                                            key_of(game, KeyAction::full_screen)})));
        add(view::corner_button_shapes(settings_button(game), game.size));
        add(cover_shapes(game));
        return picture;
    }
    if (game.pointer && !game.held)
        if (auto const ball = ball_at(game, camera, *game.pointer)) {
            Seen const seen = seen_ball(game, camera, moment, *ball);
            add(view::grip_shapes(seen.centre, seen.radius, view::hud_scale(game.size)));
        }
    double const presence = briefing_presence(game);
    view::Side const side = side_of_briefing(game);
    add(view::briefing_shapes(*game.stage->level, presence, game.size, side, wording_of(game)));
    add(lesson_shapes(game, camera, moment));
    std::string const badge = badge_of(game);
    if (!badge.empty()) add(view::badge_shapes(badge, game.size));
    if (shows_timeline(game)) add(view::timeline_shapes(timeline_of(game), game.size));
    bool const in_fault = !game.fault.empty() && game.toast.left <= 0;
    double const lift = presence > 0 && side == view::Side::lower ? lift_over_briefing * view::hud_scale(game.size) : 0;
    if (game.menu_row && !game.settings) add(menu_shapes(game));
    add(cover_shapes(game, in_fault ? game.fault : std::string(), lift));
    return picture;
}

view::Picture picture_of(PlayGame const& game, Picker const& picker) {
    view::Picture picture = view::picker_picture(picker.tiles, picker.chosen, game.size, language_of(game));
    auto const add = [&](std::vector<view::Shape> more) { add_written(game, picture, std::move(more)); };
    add(view::corner_button_shapes(settings_button(game), game.size));
    add(cover_shapes(game));
    return picture;
}

bool is_on_film_button(PlayGame const& game, Vec2 const& pixel) {
    if (!is_card_open(game) || !game.session.goal_time) return false;
    view::Moment const moment = view::moment_of(game.session, shown_time(game), view::Recall::nothing);
    return view::is_on_film_button(*game.stage->level, moment, pixel, game.size, ending_note(game, moment));
}

}  // namespace app
