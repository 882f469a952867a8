// smb2d verify: simulates a run again and compares with what it claims.
#include <memory>
#include <string>
#include <vector>

#include "app/command.h"
#include "app/opening.h"
#include "app/options.h"
#include "app/output.h"
#include "app/chunked_advance.h"

namespace app {

namespace {

struct VerifyOptions {
    std::vector<std::string> files;
    MethodOptions method;
};

std::string difference(std::string const& key, std::string const& claimed, std::string const& found) {
    return key + " is " + found + ", the run says " + claimed;
}

// What differs; nothing when all that the run claims is so.
std::vector<std::string> differences_in(Opened const& opened, game::MethodWish const& wish) {
    game::Run const& run = opened.run;
    std::vector<std::string> differences;
    if (run.level_hash && *run.level_hash != opened.level->hash)
        differences.push_back(difference("level_hash", *run.level_hash, opened.level->hash));
    game::Session session = watched_session_for(opened, wish);
    if (!run.final) return differences;
    double const end = run.duration.value_or(run.final->time);
    if (end != run.final->time)
        differences.push_back(difference("time", seventeen_digits(run.final->time), seventeen_digits(end)));
    if (!run.final->state_hash) return differences;
    advance_in_chunks(session, end);
    expect_tolerance_kept(opened.file, session);
    std::string const hash = game::state_hash(session, end);
    if (hash != *run.final->state_hash) differences.push_back(difference("state_hash", *run.final->state_hash, hash));
    return differences;
}

std::string verdict_on(Opened const& opened, std::vector<std::string> const& differences) {
    if (differences.empty()) return opened.file + (opened.run.final ? ": ok" : ": ok, it claims no final state");
    std::string verdict = opened.file;
    for (std::string const& difference : differences)
        verdict += (&difference == &differences.front() ? ": " : "; ") + difference;
    return verdict;
}

int verify(VerifyOptions const& options) {
    game::MethodWish const wish = wish_from(options.method);
    int status = done;
    std::string unreadable;
    for (std::string const& file : options.files) {
        std::string verdict;
        try {
            Opened const opening = opened(file);
            if (!opening.is_run) throw std::runtime_error(file + ": is a level, not a run");
            note_misspellings(*opening.level);
            note_choice(opening, wish);
            auto const differences = differences_in(opening, wish);
            if (!differences.empty()) status = fault_found;
            verdict = verdict_on(opening, differences) + "\n";
        } catch (std::runtime_error const& error) {
            unreadable += (unreadable.empty() ? "" : "; ") + std::string(error.what());
        }
        write_to_stdout(verdict);
    }
    if (!unreadable.empty()) throw std::runtime_error(unreadable);
    return status;
}

}  // namespace

Command verify_command(CommandLine& program) {
    auto const options = std::make_shared<VerifyOptions>();
    Subcommand command = program.add("verify", "Simulate runs again and compare with what they claim");
    command.needs("files", options->files, "runs (.json)", "RUN");
    declare(command, options->method);
    command.ends_help_with("Ends with 3 when a run differs. Example: smb2d verify assets/runs/*.json");
    return {command, [options] { return verify(*options); }};
}

}  // namespace app
