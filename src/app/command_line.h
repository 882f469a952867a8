// The words that are typed: which subcommands there are and what each of them takes. CLI11 stands behind it, in one
// file, for it takes long to compile.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace app {

// What one subcommand takes. Values are written to the variables named here when the words are read, and not at all
// where nothing is typed: the variables must outlive the reading. `names` are as in "-s,--size", or a bare word for
// what is given without a name; `kind` stands for the value in the help.
class Subcommand {
public:
    explicit Subcommand(CLI::App& parser) : parser_(&parser) {}

    void needs(std::string const& names, std::string& value, std::string const& help, std::string const& kind);
    void needs(std::string const& names, std::vector<std::string>& values, std::string const& help,
               std::string const& kind);
    void takes(std::string const& names, std::string& value, std::string const& help, std::string const& kind);
    void takes(std::string const& names, std::optional<std::string>& value, std::string const& help,
               std::string const& kind);
    void takes_flag(std::string const& names, bool& value, std::string const& help);
    void ends_help_with(std::string const& text);

    bool is_chosen() const;  // by the words that were read

private:
    CLI::App* parser_;  // owned by the command line
};

class CommandLine {
public:
    CommandLine(std::string const& name, std::string const& version, std::string const& help,
                std::string const& end_of_help);
    ~CommandLine();

    Subcommand add(std::string const& name, std::string const& help);
    bool has(std::string const& subcommand) const;

    // The help or the version where these are asked for, else nothing: then one subcommand is chosen. Throws
    // UsageError.
    std::optional<std::string> read(std::vector<std::string> words);

private:
    std::unique_ptr<CLI::App> parser_;
};

}  // namespace app
