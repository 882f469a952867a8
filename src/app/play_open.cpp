// A level or a run opened, and opened anew: by the player, or because its file has been saved.
#include <algorithm>
#include <filesystem>

#include "app/output.h"
#include "app/play_game.h"
#include "game/best_times.h"

namespace app {

namespace {

void open_session(PlayGame& game, Opened const& opening) {
    note_changed_level(opening);
    note_misspellings(*opening.level);
    game.session = session_for(opening, game.wish);
    game.pace.ticks = 0;
    game.pace.rest = 0;
    game.pace.paused = false;
    game.replay_end.reset();
    if (opening.is_run) game.replay_end = duration_of(opening.run).value();
    game.held.reset();
    game.sent.reset();
    game.looked_at.reset();
    game.noted = opening.is_run;
    game.waiting = !opening.is_run;
    game.wall_time = 0;
    game.over_since.reset();
    game.ghost.reset();
    game.on_timeline = false;
    game.best_before = game::best_time(*opening.level);
    game.learnt = game::learnt_lessons();
}

}  // namespace

PlayGame game_of(std::string const& file, game::MethodWish const& wish) {
    PlayGame game;
    game.file = file;
    game.wish = wish;
    Opened const opening = opened(file);
    game.watch.read = stamp_of(opening.level->file);
    game.stage = std::make_shared<view::Stage const>(view::stage_of(opening.level));
    open_session(game, opening);
    return game;
}

namespace {

// Another game, looked at as the one before.
void adopt(PlayGame& game, PlayGame other) {
    other.pace.speed = game.pace.speed;
    other.size = game.size;
    other.overlays = game.overlays;
    other.preferences = game.preferences;
    other.kept_upright = game.kept_upright;
    other.bindings = game.bindings;
    other.lean = game.lean;
    other.lean_is_old = leaning_of(game) != 0;
    other.stick = game.stick;
    other.pointer = game.pointer;
    game = std::move(other);
}

// Without the folders, which the player knows.
std::string brief(std::string const& message, std::string const& file) {
    if (message.substr(0, file.size()) != file) return message;
    return std::filesystem::path(file).filename().string() + message.substr(file.size());
}

// How many faults the file has besides the one that is told, in words; nothing where that is all.
std::string further_faults_in(std::string const& file) {
    try {
        auto const findings = level::checked_level(file).findings;
        auto const faults =
            std::count_if(findings.begin(), findings.end(), [](level::Finding const& found) { return found.fault; });
        return faults < 2 ? "" : ", and " + std::to_string(faults - 1) + " more (smb2d check)";
    } catch (std::exception const&) {
        return {};
    }
}

}  // namespace

void change_to(PlayGame& game, std::string const& file) {
    try {
        adopt(game, game_of(file, game.wish));
        game.toast = {};
    } catch (std::exception const& error) {
        say(game, error.what());
        note(std::string("smb2d: ") + error.what());
    }
}

void restart(PlayGame& game) {
    view::Lens const lens = game.lens;
    Screen const screen = game.screen;
    std::shared_ptr<game::Session const> const companion = game.companion;
    change_to(game, game.file);
    game.companion = companion;
    game.lens = lens;
    game.screen = screen;
    game.wall_time = flight_time;
}

void accompany(PlayGame& game, std::string const& run) {
    Opened const opening = opened(run);
    if (opening.level->hash != game.stage->level->hash)
        throw std::runtime_error(run + ": is a run of another level than " + game.stage->level->file);
    auto session = std::make_shared<game::Session>(session_for(opening, {}));
    game::advance(*session, duration_of(opening.run).value());
    game.companion = std::move(session);
}

PlayGame title_of_run(std::string const& run, game::MethodWish const& wish) {
    PlayGame game = game_of(run, wish);
    game.screen = Screen::title;
    return game;
}

bool follow_file(PlayGame& game, double elapsed) {
    std::string const file = game.stage->level->file;
    if (!is_saved_anew(game.watch, file, elapsed)) return false;
    try {
        view::Lens const lens = game.lens;
        adopt(game, game_of(game.file, game.wish));
        game.lens = lens;
        say(game, game::Text::read_anew);
        return true;
    } catch (std::exception const& error) {
        std::string const what = error.what() + further_faults_in(file);
        game.fault = brief(what, file);
        note("smb2d: " + what);
        return false;
    }
}

void change_method(PlayGame& game) {
    char const* const names[] = {"article", "euler", "steps", "exact"};
    std::size_t constexpr count = std::size(names);
    std::string const now = physics::name_of(game.session.method);
    std::size_t const at = static_cast<std::size_t>(std::find(names, names + count, now) - names);
    for (std::size_t i = 1; i <= count; ++i) {
        game::MethodWish const wish{names[(at + i) % count], game.wish.rate, game.wish.tolerance};
        if (game::objection_to(wish)) continue;
        game.wish = wish;
        restart(game);
        say(game, game::Text::method_is, {physics::name_of(game.session.method)});
        return;
    }
}

}  // namespace app
