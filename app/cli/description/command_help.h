#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace angiopose::app {

/// An option or operand of a command, as shown by `--help`.
struct OptionHelp {
    std::vector<std::string> names;   ///< e.g. "-h", "--help"; an operand has one name, e.g. "CASE"
    std::string value;   ///< type of the value, e.g. "INT in [1 - 200]"; empty for flags
    std::string help;
    std::vector<std::string> choices;   ///< allowed values; empty if they are not known
    bool isRequired = false;
    bool mayRepeat = false;

    bool isFlag() const { return value.empty(); }
    bool isFile() const { return choices.empty() && value.starts_with("TEXT"); }   ///< whether the value may be a file
};

/// A command as described in the man page and the completions.
struct CommandHelp {
    std::string name;
    std::string summary;
    std::vector<OptionHelp> options;
    std::vector<OptionHelp> operands;
    std::string footer;
};

struct ProgramHelp {
    CommandHelp mainCommand;
    std::vector<CommandHelp> commands;   ///< commands listed by `--help`
};

/// Collects the help of the program and its commands.
ProgramHelp collectHelp(const CLI::App& app);

/// Returns the man page (section 1) in roff format.
std::string makeManPage(const ProgramHelp& program);

/// Returns the commands as a manual page in Markdown.
std::string makeMarkdownPage(const ProgramHelp& program);

/// Return shell completions for the commands, the options and their values, and files.
std::string makeBashCompletion(const ProgramHelp& program);
std::string makeZshCompletion(const ProgramHelp& program);
std::string makeFishCompletion(const ProgramHelp& program);

}   // namespace angiopose::app
