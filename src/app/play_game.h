// One game as it is played in the window: what is simulated, how it is looked at, what the player holds. Knows no SDL.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/file_watch.h"
#include "app/opening.h"
#include "game/actions.h"
#include "game/lessons.h"
#include "game/pace.h"
#include "game/preferences.h"
#include "game/session.h"
#include "view/scene_picture.h"
#include "view/timeline.h"
#include "view/turning.h"

namespace app {

using geometry::Vec2;

struct Toast {
    std::string text;
    double left = 0;  // s on the wall until it is gone
};

// The page of settings that is open: all of them, or the keys.
struct SettingsPage {
    enum class Leaf { all, keys } leaf = Leaf::all;
    std::size_t row = 0;  // the chosen one
    bool waits = false;   // for the key that the chosen action is to have
};

// How the window is used: over a run that shows the game, or to play.
enum class Screen { title, game };

struct PlayGame {
    Screen screen = Screen::game;
    std::string file;       // the level or run that was asked for
    game::MethodWish wish;  // of the command line, or of the key that changes the method
    FileWatch watch;        // of the level's file
    std::string fault;      // of that file as it was last saved, while the level that was read before plays on
    std::shared_ptr<view::Stage const> stage;
    game::Session session;
    game::Pace pace;
    std::optional<double> replay_end;                // s, while a run is being replayed
    bool waiting = false;                            // the world waits for the player's first input
    double wall_time = 0;                            // s, since the level was opened
    double started_at = 0;                           // s of wall time, when the waiting was over
    std::optional<double> over_since;                // s of wall time, when the game that the player plays was over
    std::shared_ptr<game::Session const> companion;  // a run that rolls along as a ghost
    std::optional<game::Session> ghost;              // what was played before the player went on from the past

    Vec2 size = Vec2(1280, 720);  // pixels, of the picture
    view::Lens lens;
    bool kept_upright = false;  // the picture does not turn, whatever is preferred
    view::Overlays overlays;
    game::Preferences preferences;
    game::Bindings bindings = game::usual_bindings();
    std::optional<Vec2> pointer;      // pixels, where it was last seen
    std::optional<Vec2> held;         // pixels, the pointer while it drags a ball
    std::optional<Vec2> sent;         // m, where it was when it was last told to the session
    std::optional<double> looked_at;  // s, a moment of the past; nothing = the present
    double scrub_held = 0;            // s on the wall, for how long the key that moves through the past is down
    int lean = 0;                     // -1, 0, 1: to which side keys tilt the stage
    bool lean_is_old = false;         // since the level before: it begins nothing
    double stick = 0;                 // in [-1, 1]: the same of a gamepad
    Toast toast;
    bool help = false;
    bool film_wanted = false;             // of what has been played
    std::optional<double> filmed;         // in [0, 1], how much of a film is done that is being made
    std::optional<std::size_t> menu_row;  // the chosen one, while the menu is open
    std::optional<SettingsPage> settings;
    bool on_timeline = false;           // the pointer drags the moment that is looked at
    bool noted = false;                 // the time of reaching the goal has been noted
    std::optional<double> best_before;  // s, the level's best time when it was opened
    std::set<game::Lesson> learnt;      // what need not be shown again
};

// The run that plays under the title, again and again.
PlayGame title_of_run(std::string const& run, game::MethodWish const& wish);

// A run that is to roll along with the game. Throws std::runtime_error, also where it is of another level.
void accompany(PlayGame& game, std::string const& run);

// Throws std::runtime_error.
PlayGame game_of(std::string const& file, game::MethodWish const& wish);

// The same level from its beginning, looked at as before.
void restart(PlayGame& game);
// Another level or run, looked at as before. Says so in a toast when it cannot be opened, and stays.
void change_to(PlayGame& game, std::string const& file);
// Reads the level anew when its file has been saved, and begins it; whether it did. What is wrong with the file is told
// until it is mended. `elapsed` seconds have passed on the wall.
bool follow_file(PlayGame& game, double elapsed);
// The next method, from the beginning of the level.
void change_method(PlayGame& game);

inline double present_time(PlayGame const& game) { return game::simulated_time(game.pace); }
inline double shown_time(PlayGame const& game) { return game.looked_at.value_or(present_time(game)); }
view::Camera camera_of(PlayGame const& game);

// Goal, fall or the end of the time: the ball is no longer the player's.
bool is_over(PlayGame const& game);
// The card has been there long enough to be seen.
bool is_card_open(PlayGame const& game);

// The first input, or the player's wish, lets the time begin.
void begin(PlayGame& game);

inline constexpr double flight_time = 1.8;  // s on the wall, from the goal to the ball
// From 1 at the goal to 0 at the ball: how far the flight over the level has still to go.
double flight_of(PlayGame const& game);

// How far the player tilts the stage, in [-1, 1]: by keys, or else by a gamepad.
inline double leaning_of(PlayGame const& game) { return game.lean != 0 ? game.lean : game.stick; }

// Looking back through the past that is kept; the game stands still meanwhile. A key that is pressed moves by a frame,
// one that is held goes on; -1 is back, 1 forward. In the present, forward is a single step.
enum class Hurry { calm, fast };
void start_scrub(PlayGame& game, int direction, Hurry hurry);
void scrub(PlayGame& game, int direction, Hurry hurry, double elapsed);
// Plays on from the present; whether the past was looked at.
bool return_to_present(PlayGame& game);
view::Timeline timeline_of(PlayGame const& game);
// The moment under the pointer.
void look_at_timeline(PlayGame& game, Vec2 const& pixel);
bool shows_timeline(PlayGame const& game);

// The game goes on from the moment of the past that is looked at; what came after it stays as a ghost.
void go_on_from_past(PlayGame& game);

// Whether the timeline is there to be pressed: while the player looks back, and after a fall.
bool is_on_timeline(PlayGame const& game, Vec2 const& pixel);

enum class Pressed { ball, timeline, nothing };
// A ball is taken hold of by a press on it or near it, also in a pause, and in the past, from which the game then goes
// on.
Pressed press(PlayGame& game, Vec2 const& pixel);
void move_pointer(PlayGame& game, Vec2 const& pixel);
void release(PlayGame& game);
// The window is no longer told what the pointer does, nor that its button comes up: what is dragged is let go, and a
// game that the player plays pauses.
void lose_focus(PlayGame& game);
// The ball that a press there would take hold of; `camera` is camera_of the game.
std::optional<int> ball_at(PlayGame const& game, view::Camera const& camera, Vec2 const& pixel);

void turn_wheel(PlayGame& game, Vec2 const& pixel, double notches);
void single_step(PlayGame& game);
void cycle_overlay(PlayGame& game);
void switch_turning(PlayGame& game);
// Into the user's data folder, never over another file; tells where, or why not, in a toast and on standard error.
std::optional<std::string> save_run(PlayGame& game);  // the run's file

void say(PlayGame& game, std::string const& text);
void say(PlayGame& game, game::Text text, std::initializer_list<std::string> values = {});
inline game::Language language_of(PlayGame const& game) { return game::language_of(game.preferences); }
// The first key of an action, as the player reads it.
std::string key_of(PlayGame const& game, game::KeyAction action);
// Whether the picture turns with gravity, and how it is looked at, by what is preferred.
view::Turning turning_of(PlayGame const& game);
view::Lens lens_of(PlayGame const& game);
inline view::Motion motion_of(PlayGame const& game) {
    return game.preferences.reduced_motion ? view::Motion::reduced : view::Motion::full;
}

// The card after the goal has a button that films the run.
bool is_on_film_button(PlayGame const& game, Vec2 const& pixel);

// A message fades, be the game on or not; `elapsed` as below.
void let_toast_fade(PlayGame& game, double elapsed);

// `elapsed` seconds have passed on the wall.
void pass(PlayGame& game, double elapsed);

// `camera` is camera_of the game, which takes some time to find.
view::Picture picture_of(PlayGame const& game, view::Camera const& camera);

}  // namespace app
