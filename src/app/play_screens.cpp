#include "app/play_screens.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "app/assets.h"
#include "app/output.h"
#include "app/play_settings.h"
#include "app/play_sound.h"

namespace app {

namespace {

using game::KeyAction;

bool is_same_file(std::string const& a, std::string const& b) {
    std::error_code none;
    return a == b || std::filesystem::equivalent(a, b, none);
}

void play_choice(PlayGame& game, Tour& tour, screen::Window& window) {
    std::size_t const before = std::exchange(tour.at, tour.picker->chosen);
    go_to_level(game, tour, 0, window);
    // What is wrong with a broken level is told over the levels, where another one can be chosen.
    if (game.file == tour.files[tour.at])
        tour.picker.reset();
    else
        tour.at = before;
}

// The first level without a best time, else the first.
std::size_t first_unfinished(Tour const& tour) {
    Picker const levels = picker_of(tour.files, 0);
    auto const unfinished = std::find_if(levels.tiles.begin(), levels.tiles.end(),
                                         [](view::Tile const& tile) { return tile.thumbnail && !tile.best; });
    return unfinished == levels.tiles.end() ? 0 : static_cast<std::size_t>(unfinished - levels.tiles.begin());
}

}  // namespace

std::string settings_button(PlayGame const& game) {
    return game::words(game::Text::menu_settings, language_of(game)) + "  " + key_of(game, KeyAction::settings);
}

Vec2 pixel_at(int x, int y, screen::Window const& window) { return Vec2(x, y) * window.pixel_ratio(); }

void go_to_level(PlayGame& game, Tour& tour, std::size_t by, screen::Window& window) {
    window.release_pointer();
    tour.at = (tour.at + by) % tour.files.size();
    change_to(game, tour.files[tour.at]);
    window.retitle(title_of(game));
}

void open_picker(PlayGame& game, Tour& tour, screen::Window& window) {
    window.release_pointer();
    release(game);
    tour.picker = picker_of(tour.files, tour.at);
}

void open_dropped(std::string const& file, PlayGame& game, Tour& tour, screen::Window& window) {
    try {
        Tour dropped = tour_of(file);
        go_to_level(game, dropped, 0, window);
        if (game.file == dropped.files[dropped.at] || dropped.picker) tour = std::move(dropped);
    } catch (std::exception const& error) {
        say(game, error.what());
        note(std::string("smb2d: ") + error.what());
    }
}

bool press_anywhere(Press const& press, PlayGame& game, screen::Window& window) {
    if (!press.action) return false;
    switch (*press.action) {
        case KeyAction::help:
            game.help = !game.help;
            return true;
        case KeyAction::full_screen:
            window.toggle_fullscreen();
            return true;
        case KeyAction::mute:
            toggle_mute(game);
            return true;
        case KeyAction::softer:
            turn_volume(game, -1);
            return true;
        case KeyAction::louder:
            turn_volume(game, 1);
            return true;
        default:
            return false;
    }
}

KeyCommand press_in_picker(Press const& press, PlayGame& game, Tour& tour, screen::Window& window) {
    Picker& picker = *tour.picker;
    std::optional<Move> move = press.move;
    if (!move && press.action == KeyAction::tilt_left) move = Move::left;
    if (!move && press.action == KeyAction::tilt_right) move = Move::right;
    if (!move && press.action == KeyAction::quit) return KeyCommand::quit;
    if (!move && (press.action == KeyAction::levels || press.action == KeyAction::menu)) move = Move::back;
    if (!move) return KeyCommand::stay;
    switch (*move) {
        case Move::left:
            move_choice(picker, -1, 0);
            break;
        case Move::right:
            move_choice(picker, 1, 0);
            break;
        case Move::up:
            move_choice(picker, 0, -1);
            break;
        case Move::down:
            move_choice(picker, 0, 1);
            break;
        case Move::choose:
            play_choice(game, tour, window);
            break;
        case Move::back:
            tour.picker.reset();
            break;
    }
    return KeyCommand::stay;
}

void point_in_picker(Vec2 const& pixel, PlayGame const& game, Tour& tour) {
    tour.picker->chosen = tile_at(*tour.picker, pixel, game.size).value_or(tour.picker->chosen);
}

void click_in_picker(Vec2 const& pixel, PlayGame& game, Tour& tour, screen::Window& window) {
    if (view::is_on_corner_button(settings_button(game), pixel, game.size)) return open_settings(game);
    Picker& picker = *tour.picker;
    if (int const way = view::scroll_at(picker.tiles.size(), picker.chosen, pixel, game.size); way != 0)
        return scroll_picker(picker, way);
    auto const tile = tile_at(*tour.picker, pixel, game.size);
    if (!tile) return;
    tour.picker->chosen = *tile;
    play_choice(game, tour, window);
}

KeyCommand press_on_title(Press const& press, PlayGame& game, Tour& tour, screen::Window& window) {
    if (press.repeats) return KeyCommand::stay;
    if (press.action == KeyAction::quit || press.action == KeyAction::menu || press.move == Move::back)
        return KeyCommand::quit;
    if (press.action == KeyAction::levels)
        open_picker(game, tour, window);
    else
        go_to_level(game, tour, first_unfinished(tour), window);
    return KeyCommand::stay;
}

void click_on_title(Vec2 const& pixel, PlayGame& game, Tour& tour, screen::Window& window) {
    if (view::is_on_corner_button(settings_button(game), pixel, game.size)) return open_settings(game);
    go_to_level(game, tour, first_unfinished(tour), window);
}

KeyCommand follow_choice(std::optional<Choice> const& choice, PlayGame& game, Tour& tour, screen::Window& window) {
    if (!choice) return KeyCommand::stay;
    if (*choice == Choice::sound) {
        toggle_mute(game);
        return KeyCommand::stay;
    }
    if (*choice == Choice::settings) {
        open_settings(game);
        return KeyCommand::stay;
    }
    close_menu(game);
    if (*choice == Choice::quit) return KeyCommand::quit;
    if (*choice == Choice::again) restart(game);
    if (*choice == Choice::levels) open_picker(game, tour, window);
    return KeyCommand::stay;
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

Tour tour_of(std::string const& file_or_folder) {
    std::error_code missing;
    bool const is_folder = std::filesystem::is_directory(file_or_folder, missing);
    return is_folder ? tour_of_folder(file_or_folder) : tour_from(file_or_folder);
}

std::string title_of(PlayGame const& game) {
    level::Level const& level = *game.stage->level;
    std::string const name = level.title.empty() ? std::filesystem::path(level.file).stem().string() : level.title;
    return "Super Monkey Ball 2D - " + name;
}

}  // namespace app
