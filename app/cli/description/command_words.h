#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace angiopose::app {

/// Option or operand of a command, as shown by `--help`.
struct OptionWords {
    std::vector<std::string> names;   ///< e.g. "-h", "--help"; an operand has one name, e.g. "CASE"
    std::string value;   ///< type of the value, e.g. "INT in [1 - 200]"; empty for flags
    std::string help;
    std::vector<std::string> choices;   ///< allowed values; empty if not known
    bool isRequired = false;
    bool mayRepeat = false;

    bool isFlag() const { return value.empty(); }
    bool isFile() const { return choices.empty() && value.starts_with("TEXT"); }   ///< true if the value may be a file
};

/// Command as described in the man page and the completions.
struct CommandWords {
    std::string name;
    std::string summary;
    std::vector<OptionWords> options;
    std::vector<OptionWords> operands;
    std::string footer;
};

struct ProgramWords {
    CommandWords itself;
    std::vector<CommandWords> commands;   ///< commands listed by `--help`
};

/// Collects the help texts of the program and its commands.
ProgramWords wordsOf(const CLI::App& app);

/// Returns the man page (section 1) in roff format.
std::string manPageOf(const ProgramWords& program);

/// Returns the commands as a manual page in Markdown.
std::string commandPageOf(const ProgramWords& program);

/// Return shell completions for commands, options, their values and files.
std::string bashCompletionOf(const ProgramWords& program);
std::string zshCompletionOf(const ProgramWords& program);
std::string fishCompletionOf(const ProgramWords& program);

}   // namespace angiopose::app
