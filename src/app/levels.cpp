// smb2d levels: the levels that ship, with title and best time.
#include <cstdio>
#include <map>
#include <string>

#include "app/assets.h"
#include "app/command.h"
#include "app/opening.h"
#include "app/output.h"
#include "game/best_times.h"
#include "level/level.h"

namespace app {

namespace {

std::string best_in(std::map<std::string, double> const& times, level::Level const& level) {
    auto const found = times.find(level.hash);
    if (found == times.end()) return "-";
    char text[64];
    std::snprintf(text, sizeof text, "%.2f s", found->second);
    return text;
}

void list(std::vector<std::filesystem::path> const& files, std::map<std::string, double> const& times) {
    for (std::filesystem::path const& file : files) {
        level::Level const level = level::read_level(file.string());
        note_misspellings(level);
        write_to_stdout(file.string() + "\t" + level.title + "\t" + best_in(times, level) + "\n");
    }
}

int levels() {
    if (shipped_levels().empty()) throw std::runtime_error("the levels that ship with this program were not found");
    auto const times = game::best_times();
    list(shipped_levels(), times);
    list(shipped_experiments(), times);
    return done;
}

}  // namespace

Command levels_command(CommandLine& program) {
    Subcommand command = program.add("levels", "The levels that ship: file, title and best time");
    command.ends_help_with("Example: smb2d levels");
    return {command, [] { return levels(); }};
}

}  // namespace app
