#include "app/opening.h"

#include "app/output.h"
#include "game/run_file.h"
#include "game/tolerance.h"

namespace app {

namespace {

constexpr double default_duration = 10;  // s, docs/command-line.md

// What the command line leaves open the run decides. A tolerance that is asked for weighs more than the rate that a run
// was made with.
game::MethodWish whole_wish(Opened const& opened, game::MethodWish const& wish) {
    game::MethodWish whole = wish;
    if (!whole.name) whole.name = opened.run.method_name;
    if (!whole.rate && !whole.tolerance) whole.rate = opened.run.rate;
    if (auto const objection = game::objection_to(whole)) throw std::runtime_error(opened.file + ": " + *objection);
    return whole;
}

}  // namespace

Opened opened(std::string const& file) {
    Opened result;
    result.file = file;
    result.is_run = game::is_run_file(file);
    if (result.is_run)
        result.run = game::read_run(file);
    else
        result.run.level_file = file;
    result.level = std::make_shared<level::Level const>(level::read_level(result.run.level_file));
    return result;
}

void note_changed_level(Opened const& opened) {
    if (opened.run.level_hash && *opened.run.level_hash != opened.level->hash)
        note("smb2d: " + opened.file + ": the level " + opened.level->file + " has changed since this run was made");
}

void note_misspellings(level::Level const& level) {
    for (level::Finding const& finding : level.misspellings)
        note("smb2d: " + level.file + ":" + std::to_string(finding.line) + ": warning: " + finding.text);
}

void note_choice(Opened const& opened, game::MethodWish const& wish) {
    game::MethodWish const whole = whole_wish(opened, wish);
    if (!whole.tolerance) return;
    bool const is_named = whole.name.value_or("auto") != "auto";
    physics::Choice const choice = game::choice_for(whole, opened.level->scene);
    if (is_named && game::is_promised(choice.method, opened.level->scene)) return;
    note("smb2d: " + opened.file + ": method " + physics::name_of(choice.method) + ": " + choice.why);
}

game::Session session_for(Opened const& opened, game::MethodWish const& wish) {
    return game::session_of(opened.level, game::method_for(whole_wish(opened, wish), opened.level->scene),
                            opened.run.inputs, opened.file);
}

game::Session watched_session_for(Opened const& opened, game::MethodWish const& wish) {
    game::Session session = session_for(opened, wish);
    if (wish.tolerance) game::watch_tolerance(session, *wish.tolerance);
    return session;
}

void expect_tolerance_kept(std::string const& file, game::Session const& session) {
    if (auto const missed = game::missed_tolerance(session)) throw std::runtime_error(file + ": " + *missed);
}

game::Fraction duration_of(game::Run const& run) {
    if (run.duration) return {*run.duration, 1};
    if (run.final) return {run.final->time, 1};
    return {default_duration, 1};
}

}  // namespace app
