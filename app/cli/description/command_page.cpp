#include "app/cli/description/command_page.h"

#include <sstream>

namespace angiopose::app {
namespace {

/// What Markdown would take for a mark or a column stays as it is written.
std::string plainCell(const std::string& text)
{
    std::string out;
    for (const char sign : text) {
        out += sign == '|' || sign == '*' || sign == '_' || sign == '<' ? std::string("\\") + sign
               : sign == '\n'                                           ? std::string(" ")
                                                                        : std::string(1, sign);
    }
    return out;
}

std::string headingOf(const OptionWords& option)
{
    std::string names;
    for (const std::string& name : option.names) {
        names += (names.empty() ? "`" : ", `") + name + "`";
    }
    return names;
}

void writeRow(std::ostream& out, const OptionWords& option)
{
    const bool isOperand = !option.names.front().starts_with('-');
    out << "| " << headingOf(option) << " | " << (isOperand ? "" : plainCell(option.value)) << " | "
        << plainCell(option.help) << (option.isRequired && !isOperand ? " (required)" : "")
        << (option.mayRepeat ? " (several may be given)" : "") << " |\n";
}

void writeSection(std::ostream& out, const std::string& program, const CommandWords& command)
{
    out << "## " << command.name << "\n\n" << command.summary << ".\n\n```\n" << program << " " << command.name;
    for (const OptionWords& operand : command.operands) {
        out << " " << operand.names.front();
    }
    out << " [options]\n```\n\n| | | |\n|---|---|---|\n";
    for (const OptionWords& operand : command.operands) {
        writeRow(out, operand);
    }
    for (const OptionWords& option : command.options) {
        if (option.names.back() != "--help") {   // every command has it: told once
            writeRow(out, option);
        }
    }
    if (!command.footer.empty()) {
        out << "\n```\n" << command.footer << "\n```\n";
    }
    out << "\n";
}

}   // namespace

std::string commandPageOf(const ProgramWords& program)
{
    std::ostringstream out;
    out << "# Command line\n\n"
        << program.itself.summary
        << "\n\nResults go to standard output, messages and progress to standard error. Nothing needs a display.\n\n"
        << program.itself.footer.substr(0, program.itself.footer.find('\n')) << "\n\n`" << program.itself.name
        << " COMMAND --help` tells the same as this page.\n\n";
    for (const CommandWords& command : program.commands) {
        writeSection(out, program.itself.name, command);
    }
    return out.str();
}

}   // namespace angiopose::app
