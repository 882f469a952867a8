#include "app/play_keys.h"

#include "app/play_settings.h"

namespace app {

namespace {

using game::KeyAction;

constexpr double slow_speed = 0.25;

// On from the card at the end of a game.
void close_card(PlayGame& game, Tour& tour, screen::Window& window) {
    if (!is_card_open(game)) return;
    if (game.session.goal_time) return go_to_level(game, tour, 1, window);
    window.release_pointer();
    restart(game);
}

// Which way the keys that are down now tilt the stage.
int lean_of_keys(PlayGame const& game) {
    int const left = is_down(game.bindings, KeyAction::tilt_left) ? 1 : 0;
    int const right = is_down(game.bindings, KeyAction::tilt_right) ? 1 : 0;
    return right - left;
}

Hurry hurry_of_keys() { return (SDL_GetModState() & KMOD_SHIFT) != 0 ? Hurry::fast : Hurry::calm; }

void open_menu_in(PlayGame& game, screen::Window& window) {
    window.release_pointer();
    open_menu(game);
}

void press_pause(PlayGame& game) {
    if (game.waiting)
        begin(game);
    else if (!return_to_present(game))
        game.pace.paused = !game.pace.paused;
}

Place place_of(PlayGame const& game, Tour const& tour) {
    if (game.settings) return Place::settings;
    if (tour.picker) return Place::picker;
    if (game.screen == Screen::title) return Place::title;
    if (game.menu_row) return Place::menu;
    if (is_card_open(game)) return Place::card;
    return game.waiting ? Place::waiting : Place::game;
}

bool is_list(Place place) { return place == Place::settings || place == Place::picker || place == Place::menu; }

KeyCommand press_in_game(KeyAction action, PlayGame& game, Tour& tour, screen::Window& window) {
    switch (action) {
        case KeyAction::quit:
            return KeyCommand::quit;
        case KeyAction::menu:
            open_menu_in(game, window);
            break;
        case KeyAction::pause:
            press_pause(game);
            break;
        case KeyAction::go_on:
            close_card(game, tour, window);
            break;
        case KeyAction::look_back:
            start_scrub(game, -1, hurry_of_keys());
            break;
        case KeyAction::look_forward:
            start_scrub(game, 1, hurry_of_keys());
            break;
        case KeyAction::single_step:
            single_step(game);
            break;
        case KeyAction::slow_motion:
            game.pace.speed = game.pace.speed == 1 ? slow_speed : 1;
            break;
        case KeyAction::restart:
            window.release_pointer();
            restart(game);
            break;
        case KeyAction::method:
            window.release_pointer();
            change_method(game);
            break;
        case KeyAction::next_level:
            go_to_level(game, tour, 1, window);
            break;
        case KeyAction::previous_level:
            go_to_level(game, tour, tour.files.size() - 1, window);
            break;
        case KeyAction::levels:
            open_picker(game, tour, window);
            break;
        case KeyAction::overlay:
            cycle_overlay(game);
            break;
        case KeyAction::turn_picture:
            switch_turning(game);
            break;
        case KeyAction::save:
            save_run(game);
            break;
        case KeyAction::film:
            game.film_wanted = true;
            break;
        default:
            break;
    }
    return KeyCommand::stay;
}

// Arrows, Enter and Esc come before actions in lists, after them elsewhere.
KeyCommand press(Press const& pressed, PlayGame& game, Tour& tour, screen::Window& window) {
    Place const place = place_of(game, tour);
    bool const takes_key = game.settings && game.settings->waits;
    if (takes_key) {
        press_in_settings(game, pressed);
        return KeyCommand::stay;
    }
    if (game.help && pressed.move == Move::back) {
        game.help = false;
        return KeyCommand::stay;
    }
    bool const is_move = is_list(place) && pressed.move;
    if (!is_move && !pressed.repeats && press_anywhere(pressed, game, window)) return KeyCommand::stay;
    if (!is_move && !pressed.repeats && !game.settings && pressed.action == KeyAction::settings) {
        window.release_pointer();
        open_settings(game);
        return KeyCommand::stay;
    }
    if (place == Place::settings) {
        press_in_settings(game, pressed);
        return KeyCommand::stay;
    }
    // Held down, arrows go on through a list, and steps go on in a pause.
    bool const may_repeat = is_list(place) ? is_move && *pressed.move != Move::choose && *pressed.move != Move::back
                                           : pressed.action == KeyAction::single_step;
    if (pressed.repeats && !may_repeat) return KeyCommand::stay;
    if (place == Place::picker) return press_in_picker(pressed, game, tour, window);
    if (place == Place::title) return press_on_title(pressed, game, tour, window);
    if (place == Place::menu) return follow_choice(press_in_menu(game, pressed), game, tour, window);
    return pressed.action ? press_in_game(*pressed.action, game, tour, window) : KeyCommand::stay;
}

KeyCommand click(Vec2 const& pixel, PlayGame& game, Tour& tour, screen::Window& window) {
    if (game.help) {
        game.help = false;
        return KeyCommand::stay;
    }
    switch (place_of(game, tour)) {
        case Place::settings:
            click_in_settings(game, pixel);
            break;
        case Place::picker:
            click_in_picker(pixel, game, tour, window);
            break;
        case Place::title:
            click_on_title(pixel, game, tour, window);
            break;
        case Place::menu:
            return follow_choice(click_in_menu(game, pixel), game, tour, window);
        default:
            if (game.held) break;
            if (is_on_film_button(game, pixel)) {
                game.film_wanted = true;
                break;
            }
            if (app::press(game, pixel) != Pressed::nothing)
                window.capture_pointer();
            else
                close_card(game, tour, window);
            break;
    }
    return KeyCommand::stay;
}

void point(Vec2 const& pixel, PlayGame& game, Tour& tour) {
    Place const place = place_of(game, tour);
    if (place == Place::settings)
        point_in_settings(game, pixel);
    else if (place == Place::picker)
        point_in_picker(pixel, game, tour);
    else if (place == Place::menu)
        point_in_menu(game, pixel);
    else
        move_pointer(game, pixel);
}

void turn_wheel_at(SDL_MouseWheelEvent const& wheel, PlayGame& game, Tour& tour, screen::Window& window) {
    Place const place = place_of(game, tour);
    if (place == Place::picker) return move_choice(*tour.picker, 0, wheel.y > 0 ? -1 : 1);
    if (is_list(place)) return;
    int x = 0, y = 0;
    SDL_GetMouseState(&x, &y);
    turn_wheel(game, pixel_at(x, y, window), wheel.preciseY);
}

}  // namespace

void scrub_by_keys(PlayGame& game, double elapsed) {
    int const back = is_down(game.bindings, KeyAction::look_back) ? 1 : 0;
    int const forward = is_down(game.bindings, KeyAction::look_forward) ? 1 : 0;
    scrub(game, forward - back, hurry_of_keys(), elapsed);
}

KeyCommand listen(SDL_Event const& event, PlayGame& game, Tour& tour, screen::Window& window) {
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
            if (!is_list(place_of(game, tour))) game.lean = lean_of_keys(game);
            // Alt-Tab is the desktop's.
            if ((event.key.keysym.mod & KMOD_ALT) != 0) return KeyCommand::stay;
            return press(press_of(event.key, game.bindings), game, tour, window);
        case SDL_KEYUP:
            game.lean = lean_of_keys(game);
            break;
        case SDL_MOUSEBUTTONDOWN:
            if (event.button.button != SDL_BUTTON_LEFT) break;
            return click(pixel_at(event.button.x, event.button.y, window), game, tour, window);
        case SDL_MOUSEMOTION:
            point(pixel_at(event.motion.x, event.motion.y, window), game, tour);
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
            open_dropped(file, game, tour, window);
            break;
        }
        case SDL_MOUSEWHEEL:
            turn_wheel_at(event.wheel, game, tour, window);
            break;
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
        say(game, game::Text::pad_gone);
    }
    if (event.type != SDL_CONTROLLERBUTTONDOWN) return KeyCommand::stay;
    auto const button = static_cast<SDL_GameControllerButton>(event.cbutton.button);
    auto const pressed = press_for(button, place_of(game, tour));
    return pressed ? press(*pressed, game, tour, window) : KeyCommand::stay;
}

}  // namespace app
