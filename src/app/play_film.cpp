#include "app/play_film.h"

#include <sys/resource.h>
#include <unistd.h>

#include <filesystem>

#include "app/filming.h"
#include "app/output.h"

namespace app {

namespace {

using game::Text;

constexpr int niceness = 5;

std::string line_of(Filming::Outcome const& outcome) {
    return (outcome.whole ? "smb2d: Film saved: " : "smb2d: No film: ") + outcome.what;
}

}  // namespace

Filming::Filming(std::string const& run_file, std::string const& film_file)
    : thread_([this, run_file, film_file] { run(run_file, film_file); }) {}

Filming::~Filming() {
    given_up_ = true;
    thread_.join();
    if (auto const left = outcome()) note(line_of(*left));
}

std::optional<Filming::Outcome> Filming::outcome() {
    std::scoped_lock const lock(mutex_);
    return std::exchange(outcome_, std::nullopt);
}

void Filming::run(std::string const& run_file, std::string const& film_file) {
    leave_interrupts_to_the_main_thread();
    // Of this thread, and of the painter and the encoder that it starts.
    setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), niceness);
    Outcome outcome{true, film_file};
    try {
        FilmOptions options;
        options.sequence.file = run_file;
        options.sequence.output = film_file;
        options.sequence.quiet = true;
        options.sequence.jobs = "1";
        Sequence sequence = sequence_for(options.sequence);
        options.told = [&](long long frame) {
            if (given_up_) throw Interrupted("the film was cut short");
            share_ = static_cast<double>(frame) / static_cast<double>(sequence.count);
        };
        write_film(sequence, options);
    } catch (std::exception const& error) {
        outcome = {false, error.what()};
    }
    std::scoped_lock const lock(mutex_);
    outcome_ = std::move(outcome);
}

void PlayFilm::start(PlayGame& game) {
    if (filming_) return say(game, Text::one_film);
    if (!(game.session.world.time > 0)) return say(game, Text::nothing_played);
    auto const run = save_run(game);
    if (!run) return;
    filming_.emplace(*run, std::filesystem::path(*run).replace_extension(".mp4").string());
    say(game, Text::film_begins);
}

void PlayFilm::follow(PlayGame& game) {
    if (std::exchange(game.film_wanted, false)) start(game);
    game.filmed.reset();
    if (!filming_) return;
    game.filmed = filming_->share();
    auto const outcome = filming_->outcome();
    if (!outcome) return;
    say(game, outcome->whole ? Text::film_saved : Text::film_failed, {outcome->what});
    note(line_of(*outcome));
    filming_.reset();
}

}  // namespace app
