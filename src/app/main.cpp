// smb2d: the table of contents. Each subcommand is a file of this folder.
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "app/command.h"
#include "app/interrupt.h"
#include "app/output.h"
#include "screen/heap.h"

namespace {

using app::Command;
using app::CommandLine;

std::vector<Command> commands_of(CommandLine& program) {
    return {app::play_command(program),     app::render_command(program), app::record_command(program),
            app::simulate_command(program), app::check_command(program),  app::verify_command(program),
            app::levels_command(program)};
}

// The subcommand to the front, `play` where none is named: options are free of order.
std::vector<std::string> arranged(CommandLine const& program, std::vector<std::string> words) {
    if (words.empty()) return {"play"};
    std::string const& first = words.front();
    if (first == "--help" || first == "-h" || first == "--version" || program.has(first)) return words;
    auto named = words.end();
    if (first.starts_with('-'))
        named = std::find_if(words.begin(), words.end(), [&](auto const& word) { return program.has(word); });
    else if (first.find_first_of("./") == std::string::npos && !std::filesystem::exists(first))
        throw app::UsageError("there is neither a subcommand nor a file \"" + first + "\"; see smb2d --help");
    if (named == words.end())
        words.insert(words.begin(), "play");
    else
        std::rotate(words.begin(), named, named + 1);
    return words;
}

int run(std::vector<std::string> const& words) {
    app::CommandLine program(
        "smb2d", SMB2D_VERSION,
        "Super Monkey Ball 2D: roll a ball with the mouse; render, record and simulate it without a display.",
        "Without a subcommand: play. Example: smb2d assets/levels/01-sunny-hills.svg");
    std::vector<Command> const commands = commands_of(program);
    if (auto const text = program.read(arranged(program, words))) {
        app::write_to_stdout(*text);
        return app::done;
    }
    auto const chosen = std::find_if(commands.begin(), commands.end(),
                                     [](Command const& command) { return command.options.is_chosen(); });
    return chosen->run();
}

int fail(int status, std::string const& what) {
    app::note("smb2d: " + what);
    return status;
}

}  // namespace

int main(int count, char** words) {
    screen::prepare_heap();
    app::hold_standard_streams();
    app::watch_for_interrupts();
    try {
        return run(std::vector<std::string>(words + std::min(count, 1), words + count));
    } catch (app::UsageError const& error) {
        return fail(app::wrong_usage, error.what());
    } catch (app::Interrupted const& error) {
        return fail(app::was_interrupted, error.what());
    } catch (std::bad_alloc const&) {
        return fail(app::failed, "out of memory");
    } catch (std::exception const& error) {
        // A loop that broke off because of Ctrl-C may have met another error on its way out.
        return fail(app::is_interrupted() ? app::was_interrupted : app::failed, error.what());
    }
}
