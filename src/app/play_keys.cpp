#include "app/play_keys.h"

#include "app/play_menu.h"
#include "app/play_sound.h"

namespace app {

namespace {

constexpr double slow_speed = 0.25;

// On from the card at the end of a game.
void close_card(PlayGame& game, Tour& tour, screen::Window& window) {
    if (!is_card_open(game)) return;
    if (game.session.goal_time) return go_to_level(game, tour, 1, window);
    window.release_pointer();
    restart(game);
}

// Which way the keys that are down now tilt the stage.
int lean_of_keys() {
    Uint8 const* const down = SDL_GetKeyboardState(nullptr);
    int const left = down[SDL_SCANCODE_LEFT] || down[SDL_SCANCODE_A] ? 1 : 0;
    int const right = down[SDL_SCANCODE_RIGHT] || down[SDL_SCANCODE_D] ? 1 : 0;
    return right - left;
}

Hurry hurry_of_keys() { return (SDL_GetModState() & KMOD_SHIFT) != 0 ? Hurry::fast : Hurry::calm; }

void open_menu_in(PlayGame& game, screen::Window& window) {
    window.release_pointer();
    open_menu(game);
}

Place place_of(PlayGame const& game, Tour const& tour) {
    if (tour.picker) return Place::picker;
    if (game.screen == Screen::title) return Place::title;
    if (game.menu_row) return Place::menu;
    if (is_card_open(game)) return Place::card;
    return game.waiting ? Place::waiting : Place::game;
}

KeyCommand press_key(SDL_Keycode key, PlayGame& game, Tour& tour, screen::Window& window) {
    switch (key) {
        case SDLK_q:
            return KeyCommand::quit;
        case SDLK_ESCAPE:
            if (game.help)
                game.help = false;
            else
                open_menu_in(game, window);
            break;
        case SDLK_F1:
            game.help = !game.help;
            break;
        case SDLK_SPACE:
            if (game.waiting)
                begin(game);
            else if (!return_to_present(game))
                game.pace.paused = !game.pace.paused;
            break;
        case SDLK_RETURN:
        case SDLK_KP_ENTER:
            close_card(game, tour, window);
            break;
        case SDLK_COMMA:
        case SDLK_LESS:
            start_scrub(game, -1, hurry_of_keys());
            break;
        case SDLK_PERIOD:
        case SDLK_GREATER:
            start_scrub(game, 1, hurry_of_keys());
            break;
        case SDLK_n:
            single_step(game);
            break;
        case SDLK_s:
            game.pace.speed = game.pace.speed == 1 ? slow_speed : 1;
            break;
        case SDLK_r:
            window.release_pointer();
            restart(game);
            break;
        case SDLK_F3:
            window.release_pointer();
            change_method(game);
            break;
        case SDLK_TAB:
        case SDLK_PAGEDOWN:
            go_to_level(game, tour, 1, window);
            break;
        case SDLK_PAGEUP:
            go_to_level(game, tour, tour.files.size() - 1, window);
            break;
        case SDLK_l:
            open_picker(game, tour, window);
            break;
        case SDLK_o:
            cycle_overlay(game);
            break;
        case SDLK_t:
            switch_turning(game);
            break;
        case SDLK_F5:
            save_run(game);
            break;
        case SDLK_F6:
            game.film_wanted = true;
            break;
        case SDLK_F11:
            window.toggle_fullscreen();
            break;
        default:
            press_sound_key(key, game);
            break;
    }
    return KeyCommand::stay;
}

}  // namespace

void scrub_by_keys(PlayGame& game, double elapsed) {
    Uint8 const* const down = SDL_GetKeyboardState(nullptr);
    auto const is_down = [&](SDL_Keycode key) { return down[SDL_GetScancodeFromKey(key)] != 0 ? 1 : 0; };
    scrub(game, is_down(SDLK_PERIOD) - is_down(SDLK_COMMA), hurry_of_keys(), elapsed);
}

KeyCommand listen(SDL_Event const& event, PlayGame& game, Tour& tour, screen::Window& window) {
    if (tour.picker && listen_on_picker(event, game, tour, window)) return KeyCommand::stay;
    if (game.menu_row && is_for_menu(event)) return listen_on_menu(event, game, tour, window);
    switch (event.type) {
        case SDL_QUIT:
            return KeyCommand::quit;
        case SDL_WINDOWEVENT:
            if (event.window.event == SDL_WINDOWEVENT_CLOSE) return KeyCommand::quit;
            if (event.window.event == SDL_WINDOWEVENT_FOCUS_LOST) {
                lose_focus(game);
                window.release_pointer();
            }
            break;
        case SDL_KEYDOWN:
            if (game.screen == Screen::title) return listen_on_title(event, game, tour, window);
            game.lean = lean_of_keys();
            // Alt-Tab is the desktop's, and a key that is held down repeats single steps alone.
            if ((event.key.keysym.mod & KMOD_ALT) != 0) return KeyCommand::stay;
            if (event.key.repeat != 0 && event.key.keysym.sym != SDLK_n) return KeyCommand::stay;
            return press_key(event.key.keysym.sym, game, tour, window);
        case SDL_KEYUP:
            game.lean = lean_of_keys();
            break;
        case SDL_MOUSEBUTTONDOWN:
            if (game.screen == Screen::title) return listen_on_title(event, game, tour, window);
            if (event.button.button != SDL_BUTTON_LEFT || game.held) break;
            if (press(game, pixel_at(event.button.x, event.button.y, window)) != Pressed::nothing)
                window.capture_pointer();
            else
                close_card(game, tour, window);
            break;
        case SDL_MOUSEMOTION:
            move_pointer(game, pixel_at(event.motion.x, event.motion.y, window));
            break;
        case SDL_MOUSEBUTTONUP:
            if (event.button.button != SDL_BUTTON_LEFT) break;
            move_pointer(game, pixel_at(event.button.x, event.button.y, window));
            release(game);
            window.release_pointer();
            break;
        case SDL_DROPFILE: {
            std::string const file = event.drop.file;
            SDL_free(event.drop.file);
            tour = tour_from(file);
            go_to_level(game, tour, 0, window);
            break;
        }
        case SDL_MOUSEWHEEL: {
            int x = 0, y = 0;
            SDL_GetMouseState(&x, &y);
            turn_wheel(game, pixel_at(x, y, window), event.wheel.preciseY);
            break;
        }
        default:
            break;
    }
    return KeyCommand::stay;
}

KeyCommand listen_to_pads(SDL_Event const& event, Pads& pads, PlayGame& game, Tour& tour, screen::Window& window) {
    Pads::News const news = pads.listen(event);
    bool const is_running = place_of(game, tour) == Place::game && !game.pace.paused;
    if (news == Pads::News::went && is_running) {
        open_menu_in(game, window);
        say(game, "The gamepad is gone");
    }
    if (event.type != SDL_CONTROLLERBUTTONDOWN) return KeyCommand::stay;
    auto const button = static_cast<SDL_GameControllerButton>(event.cbutton.button);
    auto const key = key_for(button, place_of(game, tour));
    if (!key) return KeyCommand::stay;
    SDL_Event pressed{};
    pressed.type = SDL_KEYDOWN;
    pressed.key.keysym.sym = *key;
    return listen(pressed, game, tour, window);
}

}  // namespace app
