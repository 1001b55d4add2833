#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace angiopose::app {

/// An option or an operand of a command, as `--help` shows it.
struct OptionWords {
    std::vector<std::string> names;   ///< "-h", "--help"; of an operand its one name: "CASE"
    std::string value;   ///< what is to be given: "INT in [1 - 200]"; empty for flags
    std::string help;
    std::vector<std::string> choices;   ///< the values that may be given; empty where they are not known
    bool isRequired = false;
    bool mayRepeat = false;

    bool isFlag() const { return value.empty(); }
    bool isFile() const { return choices.empty() && value.starts_with("TEXT"); }   ///< it may name one
};

/// A command and its place in man page and completions.
struct CommandWords {
    std::string name;
    std::string summary;
    std::vector<OptionWords> options;
    std::vector<OptionWords> operands;
    std::string footer;
};

struct ProgramWords {
    CommandWords itself;
    std::vector<CommandWords> commands;   ///< those that `--help` lists
};

/// Everything that `--help` of the program and of its commands tells.
ProgramWords wordsOf(const CLI::App& app);

/// The page of section 1, as `man` wants it.
std::string manPageOf(const ProgramWords& program);

/// The commands as a page of the manual, in Markdown.
std::string commandPageOf(const ProgramWords& program);

/// What shells complete a command line by: commands, options, their values and files.
std::string bashCompletionOf(const ProgramWords& program);
std::string zshCompletionOf(const ProgramWords& program);
std::string fishCompletionOf(const ProgramWords& program);

}   // namespace angiopose::app
