// smb2d check: what is wrong or suspicious in a level, with file and line; what a sound one needs of a method.
#include <memory>
#include <string>
#include <vector>

#include "app/command.h"
#include "app/interrupt.h"
#include "app/options.h"
#include "app/output.h"
#include "level/level.h"
#include "level/notes.h"
#include "physics/needs.h"

namespace app {

namespace {

struct CheckOptions {
    std::vector<std::string> files;
    MethodOptions method;  // its tolerance alone
};

std::string line_for(std::string const& file, level::Finding const& finding) {
    return file + ":" + std::to_string(finding.line) + (finding.fault ? ": " : ": warning: ") + finding.text;
}

std::string clause_of(physics::Reason const& reason, level::Level const& level) {
    if (reason.surface < 0) return reason.why;
    return "surface \"" + level.surface_names[static_cast<std::size_t>(reason.surface)] + "\" " + reason.why;
}

// What a sound level asks of a method, and which one is chosen. No line number: these are no findings.
std::vector<std::string> notes_on(std::string const& file, level::Level const& level, game::MethodWish const& wish) {
    std::vector<std::string> notes;
    for (level::Finding const& remark : level.remarks)
        notes.push_back(file + ": note: line " + std::to_string(remark.line) + ": " + remark.text);
    for (std::string const& note : level::notes_on(level)) notes.push_back(file + ": note: " + note);
    for (physics::Reason const& reason : physics::needs_of(level.scene))
        notes.push_back(file + ": needs " + physics::name_of(reason.need) + ": " + clause_of(reason, level));
    physics::Choice const choice = game::choice_for(wish, level.scene);
    notes.push_back(file + ": method " + physics::name_of(choice.method) + ": " + choice.why);
    return notes;
}

int check(CheckOptions const& options) {
    game::MethodWish const wish = wish_from(options.method);
    int status = done;
    std::string unreadable;
    for (std::string const& file : options.files) {
        stop_if_interrupted();
        level::Checked checked;
        try {
            checked = level::checked_level(file);
        } catch (std::runtime_error const& error) {
            unreadable += (unreadable.empty() ? "" : "; ") + std::string(error.what());
            continue;
        }
        Output output;
        for (level::Finding const& finding : checked.findings) {
            output.add(line_for(file, finding));
            output.end_line();
        }
        if (checked.level)
            for (std::string const& line : notes_on(file, *checked.level, wish)) {
                output.add(line);
                output.end_line();
            }
        output.flush();
        if (!checked.level) status = fault_found;
    }
    if (!unreadable.empty()) throw std::runtime_error(unreadable);
    return status;
}

}  // namespace

Command check_command(CommandLine& program) {
    auto const options = std::make_shared<CheckOptions>();
    Subcommand command = program.add("check", "What is wrong or suspicious in a level, and what it needs");
    command.needs("files", options->files, "levels (.svg)", "LEVEL");
    command.takes("--tolerance", options->method.tolerance, "say which method, at which rate, keeps this error",
                  "METRES");
    command.ends_help_with("Ends with 3 when a level has a fault. Example: smb2d check assets/levels/*.svg");
    return {command, [options] { return check(*options); }};
}

}  // namespace app
