#include "app/command_line.h"

#include <algorithm>
#include <sstream>

#include <CLI/CLI.hpp>

#include "app/command.h"

namespace app {

void Subcommand::needs(std::string const& names, std::string& value, std::string const& help, std::string const& kind) {
    parser_->add_option(names, value, help)->required()->type_name(kind);
}

void Subcommand::needs(std::string const& names, std::vector<std::string>& values, std::string const& help,
                       std::string const& kind) {
    parser_->add_option(names, values, help)->required()->type_name(kind);
}

void Subcommand::takes(std::string const& names, std::string& value, std::string const& help, std::string const& kind) {
    parser_->add_option(names, value, help)->type_name(kind);
}

void Subcommand::takes(std::string const& names, std::optional<std::string>& value, std::string const& help,
                       std::string const& kind) {
    parser_->add_option(names, value, help)->type_name(kind);
}

void Subcommand::takes_flag(std::string const& names, bool& value, std::string const& help) {
    parser_->add_flag(names, value, help);
}

void Subcommand::ends_help_with(std::string const& text) { parser_->footer(text); }

bool Subcommand::is_chosen() const { return parser_->parsed(); }

CommandLine::CommandLine(std::string const& name, std::string const& version, std::string const& help,
                         std::string const& end_of_help)
    : parser_(std::make_unique<CLI::App>(help, name)) {
    parser_->footer(end_of_help);
    parser_->set_version_flag("--version", name + " " + version);
    parser_->require_subcommand(0, 1);
}

CommandLine::~CommandLine() = default;

Subcommand CommandLine::add(std::string const& name, std::string const& help) {
    return Subcommand(*parser_->add_subcommand(name, help));
}

bool CommandLine::has(std::string const& subcommand) const {
    auto const subcommands = parser_->get_subcommands([](CLI::App const*) { return true; });
    return std::any_of(subcommands.begin(), subcommands.end(),
                       [&](CLI::App const* named) { return named->get_name() == subcommand; });
}

std::optional<std::string> CommandLine::read(std::vector<std::string> words) {
    std::reverse(words.begin(), words.end());  // the parser takes them from the end
    try {
        parser_->parse(words);
    } catch (CLI::ParseError const& outcome) {
        if (outcome.get_exit_code() != 0) throw UsageError(outcome.what());
        std::ostringstream text;
        parser_->exit(outcome, text, text);
        return text.str();
    }
    return std::nullopt;
}

}  // namespace app
