#include "app/play_picker.h"

#include <algorithm>
#include <filesystem>

#include "game/best_times.h"
#include "level/level.h"

namespace app {

Picker picker_of(std::vector<std::string> const& files, std::size_t chosen) {
    Picker picker;
    picker.chosen = chosen;
    auto const times = game::best_times();
    auto const medals = game::best_medals();
    for (std::string const& file : files) {
        view::Tile& tile = picker.tiles.emplace_back();
        tile.title = std::filesystem::path(file).stem().string();
        try {
            level::Level const level = level::read_level(file);
            tile.title = level.title;
            tile.thumbnail = view::thumbnail_of(level);
            if (auto const time = times.find(level.hash); time != times.end()) tile.best = time->second;
            if (auto const medal = medals.find(level.hash); medal != medals.end()) tile.medal = medal->second;
        } catch (std::exception const&) {
            // A run in the tour, or a broken level: opening it says what is wrong.
        }
    }
    return picker;
}

void move_choice(Picker& picker, int columns, int rows) {
    auto const count = static_cast<long>(picker.tiles.size());
    long const next = static_cast<long>(picker.chosen) + columns + rows * view::picker_columns;
    if (next >= 0 && next < count) picker.chosen = static_cast<std::size_t>(next);
}

void scroll_picker(Picker& picker, int way) {
    std::size_t const count = picker.tiles.size();
    view::UnseenRows const before = view::unseen_rows(count, picker.chosen);
    // The last row may be a short one.
    for (std::size_t last = count; last != picker.chosen && view::unseen_rows(count, picker.chosen) == before;) {
        last = picker.chosen;
        move_choice(picker, 0, way);
    }
}

std::optional<std::size_t> tile_at(Picker const& picker, Vec2 const& pixel, Vec2 const& size) {
    return view::tile_at(picker.tiles.size(), picker.chosen, pixel, size);
}

}  // namespace app
