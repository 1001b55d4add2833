#include "app/cli/description/completions.h"

#include <sstream>

namespace angiopose::app {
namespace {

std::string fishQuoted(const std::string& text)
{
    std::string out;
    for (const char sign : text) {
        out += sign == '\'' || sign == '\\' ? std::string("\\") + sign : std::string(1, sign);
    }
    return "'" + out + "'";
}

std::string fishChoices(const OptionWords& option)
{
    std::string text;
    for (const std::string& choice : option.choices) {
        text += (text.empty() ? "" : " ") + choice;
    }
    return fishQuoted(text);
}

void writeFishOption(std::ostream& out, const std::string& condition, const OptionWords& option)
{
    out << "complete -c angiopose-cli -n " << fishQuoted(condition);
    for (const std::string& name : option.names) {
        out << (name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1));
    }
    if (!option.choices.empty()) {
        out << " -x -a " << fishChoices(option);
    } else if (!option.isFlag()) {
        out << (option.isFile() ? " -r -F" : " -x");
    }
    out << " -d " << fishQuoted(option.help) << "\n";
}

}   // namespace

std::string fishCompletionOf(const ProgramWords& program)
{
    std::ostringstream out;
    out << "# fish completion of angiopose-cli, written by the program itself\n";
    for (const OptionWords& option : program.itself.options) {
        writeFishOption(out, "__fish_use_subcommand", option);
    }
    for (const CommandWords& command : program.commands) {
        out << "complete -c angiopose-cli -n __fish_use_subcommand -f -a " << command.name << " -d "
            << fishQuoted(command.summary) << "\n";
        const std::string condition = "__fish_seen_subcommand_from " + command.name;
        for (const OptionWords& operand : command.operands) {
            if (!operand.choices.empty()) {
                out << "complete -c angiopose-cli -n " << fishQuoted(condition) << " -f -a " << fishChoices(operand)
                    << "\n";
            }
        }
        for (const OptionWords& option : command.options) {
            writeFishOption(out, condition, option);
        }
    }
    return out.str();
}

}   // namespace angiopose::app
