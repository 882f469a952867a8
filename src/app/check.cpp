// smb2d check: what is wrong or suspicious in a level, with file and line.
#include <memory>
#include <string>
#include <vector>

#include "app/command.h"
#include "app/interrupt.h"
#include "app/output.h"
#include "level/level.h"

namespace app {

namespace {

std::string line_for(std::string const& file, level::Finding const& finding) {
    return file + ":" + std::to_string(finding.line) + (finding.fault ? ": " : ": warning: ") + finding.text;
}

int check(std::vector<std::string> const& files) {
    int status = done;
    std::string unreadable;
    for (std::string const& file : files) {
        stop_if_interrupted();
        std::vector<level::Finding> findings;
        try {
            findings = level::findings_in(file);
        } catch (std::runtime_error const& error) {
            unreadable += (unreadable.empty() ? "" : "; ") + std::string(error.what());
        }
        Output output;
        for (level::Finding const& finding : findings) {
            output.add(line_for(file, finding));
            output.end_line();
            if (finding.fault) status = fault_found;
        }
        output.flush();
    }
    if (!unreadable.empty()) throw std::runtime_error(unreadable);
    return status;
}

}  // namespace

Command check_command(CLI::App& program) {
    auto const files = std::make_shared<std::vector<std::string>>();
    CLI::App* const command = program.add_subcommand("check", "What is wrong or suspicious in a level");
    command->add_option("files", *files, "levels (.svg)")->required()->type_name("LEVEL");
    command->footer("Ends with 3 when a level has a fault. Example: smb2d check assets/levels/*.svg");
    return {command, [files] { return check(*files); }};
}

}  // namespace app
