#include "app/play.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <stdexcept>

#include "app/assets.h"
#include "app/command.h"
#include "app/interrupt.h"
#include "app/output.h"
#include "app/play_film.h"
#include "app/play_game.h"
#include "app/play_keys.h"
#include "app/play_settings.h"
#include "app/play_sound.h"

// Where a leak checker watches; else it is null.
extern "C" void __lsan_do_leak_check() __attribute__((weak));

namespace app {

namespace {

screen::Renderer renderer_from(std::string const& name) {
    if (name == "auto") return screen::Renderer::automatic;
    if (name == "gl") return screen::Renderer::gl;
    if (name == "software") return screen::Renderer::software;
    throw UsageError("--renderer: must be auto, gl or software, got \"" + name + "\"");
}

Tour tour_for(std::string const& file) {
    if (!file.empty()) return tour_of(file);
    auto const levels = shipped_levels();
    if (levels.empty()) throw std::runtime_error("the levels that ship with this program were not found; name a level");
    return tour_from(levels.front().string());
}

// With nothing named, the title over a run of the last level.
PlayGame game_for(PlayOptions const& options, Tour const& tour, game::MethodWish const& wish) {
    auto const shown = options.file.empty() ? shipped_run_of(tour.files.back()) : std::nullopt;
    return shown ? title_of_run(shown->string(), wish) : game_of(tour.files[tour.at], wish);
}

double seconds_now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// The hand that shows over a ball; SDL's cursors must be freed before its window.
class Cursors {
public:
    enum class Shape { arrow, hand };

    void show(Shape shape) {
        if (!hand_ || shape == shown_) return;
        SDL_SetCursor(shape == Shape::hand ? hand_.get() : SDL_GetDefaultCursor());
        shown_ = shape;
    }

private:
    struct Free {
        void operator()(SDL_Cursor* cursor) const { SDL_FreeCursor(cursor); }
    };
    std::unique_ptr<SDL_Cursor, Free> hand_{SDL_CreateSystemCursor(SDL_SYSTEM_CURSOR_HAND)};
    Shape shown_ = Shape::arrow;
};

void show_cursor(Cursors& cursors, PlayGame const& game, view::Camera const& camera, screen::Window const& window) {
    int x = 0, y = 0;
    SDL_GetMouseState(&x, &y);
    bool const grips = game.held || ball_at(game, camera, Vec2(x, y) * window.pixel_ratio());
    cursors.show(grips ? Cursors::Shape::hand : Cursors::Shape::arrow);
}

void fit(PlayGame& game, screen::Window const& window) {
    screen::Extent const extent = window.extent();
    game.size = Vec2(std::max(extent.width, 1), std::max(extent.height, 1));
}

// Once nothing is left to save, when the system takes all back with the program. A leak checker wants it undone.
bool may_leave_at_once(screen::Window const& window) { return !__lsan_do_leak_check && window.may_be_left(); }

// While another thread loads OSMesa, whatever unloads a library waits for it, on busy cores for seconds. Later Mesa has
// a thread of lowest priority, and must have ended it, which it does at exit(), or that thread has to end the program.
[[noreturn]] void leave_at_once(screen::Window const& window, int status) {
    std::fflush(nullptr);
    if (window.is_loading()) std::quick_exit(status);
    std::exit(status);
}

// Until the player quits.
void loop(PlayGame& game, Tour& tour, screen::Window& window, PlaySound& sound, Cursors& cursors, Pads& pads) {
    PlayFilm film;
    for (double last = seconds_now();;) {
        stop_if_interrupted();
        SDL_Event event;
        while (SDL_PollEvent(&event) != 0) {
            if (listen(event, game, tour, window) == KeyCommand::quit) return;
            if (listen_to_pads(event, pads, game, tour, window) == KeyCommand::quit) return;
        }
        game.stick = pads.lean();
        fit(game, window);
        double const now = seconds_now();
        double const elapsed = now - last;
        last = now;
        film.follow(game);
        if (tour.picker) {
            sound.hush();
            let_toast_fade(game, elapsed);
            window.present(picture_of(game, *tour.picker));
            continue;
        }
        if (follow_file(game, elapsed)) {
            window.release_pointer();
            window.retitle(title_of(game));
        }
        pass(game, elapsed);
        scrub_by_keys(game, elapsed);
        sound.follow(game, elapsed);
        view::Camera const camera = camera_of(game);
        show_cursor(cursors, game, camera, window);
        window.present(picture_of(game, camera));
    }
}

void play_in(screen::Window& window, PlayGame& game, Tour& tour, PlayOptions const& options) {
    // Before what takes time: sound and gamepads come after it.
    fit(game, window);
    window.present(tour.picker ? picture_of(game, *tour.picker) : picture_of(game, camera_of(game)));
    try {
        PlaySound sound = options.no_sound ? PlaySound(std::nullopt) : PlaySound();
        Cursors cursors;
        Pads pads;
        loop(game, tour, window, sound, cursors, pads);
    } catch (Interrupted const& error) {
        if (!may_leave_at_once(window)) throw;
        note(std::string("smb2d: ") + error.what());
        leave_at_once(window, was_interrupted);
    }
    if (may_leave_at_once(window)) leave_at_once(window, done);
}

}  // namespace

int play(PlayOptions const& options) {
    screen::WindowSettings settings;
    settings.renderer = renderer_from(options.renderer);
    Size const size = size_from(options.size);
    settings.width = size.width;
    settings.height = size.height;
    game::MethodWish const wish = wish_from(options.method);
    Tour tour = tour_for(options.file);
    PlayGame game = game_for(options, tour, wish);
    game.kept_upright = options.no_turn;
    adopt_preferences(game);
    if (!options.ghost.empty()) accompany(game, options.ghost);
    settings.title = title_of(game);
    screen::Window window(settings);
    if (options.fullscreen) window.toggle_fullscreen();
    play_in(window, game, tour, options);
    return done;
}

Command play_command(CommandLine& program) {
    Subcommand command = program.add("play", "The window; without a file, the title and then the levels");
    auto const options = std::make_shared<PlayOptions>();
    command.takes("file", options->file, "a level (.svg), a run (.json) or a folder of levels", "LEVEL|RUN|FOLDER");
    declare(command, options->method);
    command.takes("--renderer", options->renderer, "auto, gl or software (default: auto)", "NAME");
    command.takes("-s,--size", options->size, "pixels (default: 1280x720)", "WxH");
    command.takes("--ghost", options->ghost, "a run of the same level that rolls along", "RUN");
    command.takes_flag("--no-sound", options->no_sound, "use no sound device");
    command.takes_flag("--no-turn", options->no_turn, "the picture does not turn as the stage is tilted");
    command.takes_flag("--fullscreen", options->fullscreen, "fill the screen");
    command.ends_help_with("Example: smb2d play assets/levels/01-sunny-hills.svg");
    return {command, [options] { return play(*options); }};
}

}  // namespace app
