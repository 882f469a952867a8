#include "app/play_screens.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "app/assets.h"
#include "app/play_menu.h"
#include "app/play_sound.h"

namespace app {

namespace {

bool is_same_file(std::string const& a, std::string const& b) {
    std::error_code none;
    return a == b || std::filesystem::equivalent(a, b, none);
}

void play_choice(PlayGame& game, Tour& tour, screen::Window& window) {
    std::size_t const chosen = tour.picker->chosen;
    tour.picker.reset();
    tour.at = chosen;
    go_to_level(game, tour, 0, window);
}

// The first level without a best time, else the first.
std::size_t first_unfinished(Tour const& tour) {
    Picker const levels = picker_of(tour.files, 0);
    auto const unfinished = std::find_if(levels.tiles.begin(), levels.tiles.end(),
                                         [](view::Tile const& tile) { return tile.thumbnail && !tile.best; });
    return unfinished == levels.tiles.end() ? 0 : static_cast<std::size_t>(unfinished - levels.tiles.begin());
}

}  // namespace

Vec2 pixel_at(int x, int y, screen::Window const& window) { return Vec2(x, y) * window.pixel_ratio(); }

void go_to_level(PlayGame& game, Tour& tour, std::size_t by, screen::Window& window) {
    window.release_pointer();
    tour.at = (tour.at + by) % tour.files.size();
    change_to(game, tour.files[tour.at]);
    window.retitle(title_of(game));
}

void open_picker(PlayGame& game, Tour& tour, screen::Window& window) {
    window.release_pointer();
    lose_focus(game);
    tour.picker = picker_of(tour.files, tour.at);
}

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

bool is_for_menu(SDL_Event const& event) {
    if (event.type == SDL_KEYDOWN) {
        SDL_Keycode const key = event.key.keysym.sym;
        return key != SDLK_F1 && key != SDLK_F11 && key != SDLK_m && key != SDLK_MINUS && key != SDLK_PLUS &&
               key != SDLK_EQUALS;
    }
    return event.type == SDL_MOUSEMOTION || event.type == SDL_MOUSEBUTTONDOWN || event.type == SDL_MOUSEWHEEL;
}

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

}  // namespace app
