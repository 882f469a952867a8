#include "app/play_keys.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "app/assets.h"
#include "app/play_menu.h"
#include "app/play_sound.h"

namespace app {

namespace {

constexpr double slow_speed = 0.25;

bool is_same_file(std::string const& a, std::string const& b) {
    std::error_code none;
    return a == b || std::filesystem::equivalent(a, b, none);
}

void go_to_level(PlayGame& game, Tour& tour, std::size_t by, screen::Window& window) {
    window.release_pointer();
    tour.at = (tour.at + by) % tour.files.size();
    change_to(game, tour.files[tour.at]);
    window.retitle(title_of(game));
}

// On from the card at the end of a game.
void close_card(PlayGame& game, Tour& tour, screen::Window& window) {
    if (!is_card_open(game)) return;
    if (game.session.goal_time) return go_to_level(game, tour, 1, window);
    window.release_pointer();
    restart(game);
}

Vec2 pixel_at(int x, int y, screen::Window const& window) { return Vec2(x, y) * window.pixel_ratio(); }

void open_picker(PlayGame& game, Tour& tour, screen::Window& window) {
    window.release_pointer();
    lose_focus(game);
    tour.picker = picker_of(tour.files, tour.at);
}

void play_choice(PlayGame& game, Tour& tour, screen::Window& window) {
    std::size_t const chosen = tour.picker->chosen;
    tour.picker.reset();
    tour.at = chosen;
    go_to_level(game, tour, 0, window);
}

// Whether the event was the picker's.
bool listen_on_picker(SDL_Event const& event, PlayGame& game, Tour& tour, screen::Window& window) {
    Picker& picker = *tour.picker;
    if (event.type == SDL_MOUSEMOTION) {
        Vec2 const pixel = pixel_at(event.motion.x, event.motion.y, window);
        picker.chosen = tile_at(picker, pixel, game.size).value_or(picker.chosen);
        return true;
    }
    if (event.type == SDL_MOUSEBUTTONDOWN) {
        Vec2 const pixel = pixel_at(event.button.x, event.button.y, window);
        auto const tile = tile_at(picker, pixel, game.size);
        if (tile) picker.chosen = *tile;
        if (tile) play_choice(game, tour, window);
        return true;
    }
    if (event.type == SDL_MOUSEWHEEL) {
        move_choice(picker, 0, event.wheel.y > 0 ? -1 : 1);
        return true;
    }
    if (event.type != SDL_KEYDOWN) return false;
    switch (event.key.keysym.sym) {
        case SDLK_LEFT:
        case SDLK_a:
            move_choice(picker, -1, 0);
            break;
        case SDLK_RIGHT:
        case SDLK_d:
            move_choice(picker, 1, 0);
            break;
        case SDLK_UP:
            move_choice(picker, 0, -1);
            break;
        case SDLK_DOWN:
            move_choice(picker, 0, 1);
            break;
        case SDLK_RETURN:
        case SDLK_KP_ENTER:
        case SDLK_SPACE:
            play_choice(game, tour, window);
            break;
        case SDLK_ESCAPE:
        case SDLK_l:
            tour.picker.reset();
            break;
        case SDLK_F11:
            window.toggle_fullscreen();
            break;
        default:
            return event.key.keysym.sym != SDLK_q;
    }
    return true;
}

// The first level without a best time, else the first.
std::size_t first_unfinished(Tour const& tour) {
    Picker const levels = picker_of(tour.files, 0);
    auto const unfinished = std::find_if(levels.tiles.begin(), levels.tiles.end(),
                                         [](view::Tile const& tile) { return tile.thumbnail && !tile.best; });
    return unfinished == levels.tiles.end() ? 0 : static_cast<std::size_t>(unfinished - levels.tiles.begin());
}

// Whether the key was one of those for the sound.
bool press_sound_key(SDL_Keycode key, PlayGame& game) {
    switch (key) {
        case SDLK_m:
            toggle_mute(game);
            return true;
        case SDLK_MINUS:
        case SDLK_KP_MINUS:
            turn_volume(game, -1);
            return true;
        case SDLK_PLUS:
        case SDLK_EQUALS:
        case SDLK_KP_PLUS:
            turn_volume(game, 1);
            return true;
        default:
            return false;
    }
}

// Under the title nearly every key starts the game.
KeyCommand listen_on_title(SDL_Event const& event, PlayGame& game, Tour& tour, screen::Window& window) {
    bool const clicked = event.type == SDL_MOUSEBUTTONDOWN;
    if (!clicked && (event.type != SDL_KEYDOWN || event.key.repeat != 0)) return KeyCommand::stay;
    SDL_Keycode const key = clicked ? SDLK_RETURN : event.key.keysym.sym;
    if (key == SDLK_q || (key == SDLK_ESCAPE && !game.help)) return KeyCommand::quit;
    if (!clicked && press_sound_key(key, game)) return KeyCommand::stay;
    if (key == SDLK_F1 || key == SDLK_ESCAPE)
        game.help = !game.help;
    else if (key == SDLK_l)
        open_picker(game, tour, window);
    else if (key == SDLK_F11)
        window.toggle_fullscreen();
    else
        go_to_level(game, tour, first_unfinished(tour), window);
    return KeyCommand::stay;
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

KeyCommand listen_on_menu(SDL_Event const& event, PlayGame& game, Tour& tour, screen::Window& window) {
    int x = 0, y = 0;
    SDL_GetMouseState(&x, &y);
    if (event.type == SDL_MOUSEMOTION) x = event.motion.x, y = event.motion.y;
    if (event.type == SDL_MOUSEBUTTONDOWN) x = event.button.x, y = event.button.y;
    auto const choice = choose_in_menu(game, event, pixel_at(x, y, window));
    if (!choice) return KeyCommand::stay;
    if (*choice == Choice::sound) {
        toggle_mute(game);
        return KeyCommand::stay;
    }
    close_menu(game);
    if (*choice == Choice::quit) return KeyCommand::quit;
    if (*choice == Choice::again) restart(game);
    if (*choice == Choice::levels) open_picker(game, tour, window);
    return KeyCommand::stay;
}

// Whether the menu takes the event, and nothing else does.
bool is_for_menu(SDL_Event const& event) {
    if (event.type == SDL_KEYDOWN) {
        SDL_Keycode const key = event.key.keysym.sym;
        return key != SDLK_F1 && key != SDLK_F11 && key != SDLK_m && key != SDLK_MINUS && key != SDLK_PLUS && key != SDLK_EQUALS;
    }
    return event.type == SDL_MOUSEMOTION || event.type == SDL_MOUSEBUTTONDOWN || event.type == SDL_MOUSEWHEEL;
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

Tour tour_from(std::string const& file) {
    Tour tour;
    for (std::filesystem::path const& level : shipped_levels()) tour.files.push_back(level.string());
    for (std::size_t i = 0; i < tour.files.size(); ++i)
        if (is_same_file(tour.files[i], file)) return {tour.files, i, {}};
    tour.files.insert(tour.files.begin(), file);
    return tour;
}

Tour tour_of_folder(std::string const& folder) {
    Tour tour;
    for (auto const& entry : std::filesystem::directory_iterator(folder)) {
        std::filesystem::path const ending = entry.path().extension();
        if (ending == ".svg" || ending == ".svgz") tour.files.push_back(entry.path().string());
    }
    std::sort(tour.files.begin(), tour.files.end());
    if (tour.files.empty()) throw std::runtime_error(folder + ": there is no level in this folder");
    tour.picker = picker_of(tour.files, 0);
    auto const& tiles = tour.picker->tiles;
    auto const whole = std::find_if(tiles.begin(), tiles.end(), [](view::Tile const& tile) { return tile.thumbnail; });
    if (whole != tiles.end()) tour.at = tour.picker->chosen = static_cast<std::size_t>(whole - tiles.begin());
    return tour;
}

std::string title_of(PlayGame const& game) {
    level::Level const& level = game.stage->level;
    std::string const name = level.title.empty() ? std::filesystem::path(level.file).stem().string() : level.title;
    return "Super Monkey Ball 2D - " + name;
}

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
