#include "app/cli/description/command_help.h"

#include <sstream>

namespace angiopose::app {
namespace {

/// Escapes text for roff: keeps hyphens copyable and prevents a leading dot or apostrophe from being read as a request.
std::string escaped(const std::string& text)
{
    std::string out;
    for (const char sign : text) {
        if (sign == '\\') {
            out += "\\e";
        } else if (sign == '-') {
            out += "\\-";
        } else {
            out += sign;
        }
    }
    return out.starts_with('.') || out.starts_with('\'') ? "\\&" + out : out;
}

std::string bold(const std::string& text)
{
    return "\\fB" + escaped(text) + "\\fR";
}

std::string italic(const std::string& text)
{
    return "\\fI" + escaped(text) + "\\fR";
}

std::string heading(const OptionHelp& option)
{
    std::string names;
    for (const std::string& name : option.names) {
        names += (names.empty() ? "" : ", ") + (name.starts_with('-') ? bold(name) : italic(name));
    }
    return names + (option.isFlag() || !option.names.front().starts_with('-') ? "" : " " + italic(option.value));
}

void writeOption(std::ostream& out, const OptionHelp& option)
{
    out << ".TP\n" << heading(option) << "\n";
    const bool isOperand = !option.names.front().starts_with('-');
    std::string help = option.help;
    if (isOperand && !option.choices.empty()) {
        help += (help.empty() ? "" : " ") + option.value.substr(option.value.find('{'));
    }
    out << (help.empty() ? "A file." : escaped(help)) << (option.isRequired && !isOperand ? " (required)" : "")
        << (option.mayRepeat && help.find("repeated") == std::string::npos ? " (may be repeated)" : "") << "\n";
}

/// Writes the footer line by line. A line that starts with a word and two spaces becomes a list item.
void writeFooter(std::ostream& out, const std::string& footer)
{
    std::istringstream lines(footer);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t begin = line.find_first_not_of(' ');
        if (begin == std::string::npos) {
            continue;
        }
        const std::size_t gap = line.find("  ", begin);
        if (begin == 2 && gap != std::string::npos) {
            out << ".TP\n" << bold(line.substr(begin, gap - begin)) << "\n" << escaped(line.substr(gap + 2)) << "\n";
        } else {
            out << (begin > 2 ? ".br\n" : ".PP\n") << escaped(line.substr(begin)) << "\n";
        }
    }
}

void writeCommand(std::ostream& out, const std::string& program, const CommandHelp& command)
{
    out << ".SS " << escaped(command.name) << "\n"
        << escaped(command.summary) << ".\n.PP\n"
        << bold(program) << " " << bold(command.name) << " [" << italic("options") << "]";
    for (const OptionHelp& operand : command.operands) {
        out << " " << italic(operand.names.front());
    }
    out << "\n";
    for (const OptionHelp& operand : command.operands) {
        writeOption(out, operand);
    }
    for (const OptionHelp& option : command.options) {
        if (option.names.back() != "--help") {   // the same for all commands, so described once elsewhere
            writeOption(out, option);
        }
    }
    writeFooter(out, command.footer);
}

/// Escapes characters that Markdown would interpret as markup or as a column separator.
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

std::string headingOf(const OptionHelp& option)
{
    std::string names;
    for (const std::string& name : option.names) {
        names += (names.empty() ? "`" : ", `") + name + "`";
    }
    return names;
}

void writeRow(std::ostream& out, const OptionHelp& option)
{
    const bool isOperand = !option.names.front().starts_with('-');
    out << "| " << headingOf(option) << " | " << (isOperand ? "" : plainCell(option.value)) << " | "
        << plainCell(option.help) << (option.isRequired && !isOperand ? " (required)" : "")
        << (option.mayRepeat ? " (may be repeated)" : "") << " |\n";
}

void writeSection(std::ostream& out, const std::string& program, const CommandHelp& command)
{
    out << "## " << command.name << "\n\n" << command.summary << ".\n\n```\n" << program << " " << command.name;
    for (const OptionHelp& operand : command.operands) {
        out << " " << operand.names.front();
    }
    out << " [options]\n```\n\n| | | |\n|---|---|---|\n";
    for (const OptionHelp& operand : command.operands) {
        writeRow(out, operand);
    }
    for (const OptionHelp& option : command.options) {
        if (option.names.back() != "--help") {   // the same for all commands, so described once elsewhere
            writeRow(out, option);
        }
    }
    if (!command.footer.empty()) {
        out << "\n```\n" << command.footer << "\n```\n";
    }
    out << "\n";
}

}   // namespace

std::string makeManPage(const ProgramHelp& program)
{
    const std::string& name = program.mainCommand.name;
    std::ostringstream out;
    out << ".TH ANGIOPOSE\\-CLI 1 \"\" \"AngioPose " ANGIOPOSE_VERSION "\" \"User Commands\"\n"
        << ".SH NAME\n"
        << escaped(name) << " \\- register a 3\\-D vessel tree to a 2\\-D angiogram\n"
        << ".SH SYNOPSIS\n"
        << bold(name) << " " << italic("COMMAND") << " [" << italic("options") << "] " << italic("operands")
        << "\n.br\n"
        << bold(name) << " " << italic("COMMAND") << " " << bold("--help") << "\n"
        << ".SH DESCRIPTION\n"
        << escaped(program.mainCommand.summary) << "\n.PP\n"
        << "Results are written to standard output, messages and progress to standard error. No command requires a "
           "display.\n"
        << ".SH OPTIONS\n";
    for (const OptionHelp& option : program.mainCommand.options) {
        writeOption(out, option);
    }
    out << ".SH COMMANDS\n";
    for (const CommandHelp& command : program.commands) {
        writeCommand(out, name, command);
    }
    out << ".SH EXIT STATUS\n"
        << escaped(program.mainCommand.footer.substr(0, program.mainCommand.footer.find('\n'))) << "\n"
        << ".SH SEE ALSO\n.BR angiopose (1)\n";
    return out.str();
}

std::string makeMarkdownPage(const ProgramHelp& program)
{
    std::ostringstream out;
    out << "# Command line\n\n"
        << program.mainCommand.summary
        << "\n\nResults are written to standard output, messages and progress to standard error. No command requires a "
           "display.\n\n"
        << program.mainCommand.footer.substr(0, program.mainCommand.footer.find('\n')) << "\n\n`"
        << program.mainCommand.name << " COMMAND --help` prints the same information.\n\n";
    for (const CommandHelp& command : program.commands) {
        writeSection(out, program.mainCommand.name, command);
    }
    return out.str();
}

}   // namespace angiopose::app
