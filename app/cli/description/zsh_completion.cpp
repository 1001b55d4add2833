#include "app/cli/description/completions.h"

#include <sstream>

namespace angiopose::app {
namespace {

/// Inside single quotes, where a colon or a bracket would end the part.
std::string zshEscaped(const std::string& text)
{
    std::string out;
    for (const char sign : text) {
        if (sign == '\'') {
            out += "'\\''";
        } else if (sign == ':' || sign == '[' || sign == ']' || sign == '\\') {
            out += std::string("\\") + sign;
        } else {
            out += sign;
        }
    }
    return out;
}

/// ":TEXT:(a b)": what is completed for a value.
std::string zshValue(const OptionWords& option, const std::string& called)
{
    std::string action = option.isFile() ? "_files" : " ";
    if (!option.choices.empty()) {
        action = "(";
        for (const std::string& choice : option.choices) {
            action += (action.size() > 1 ? " " : "") + zshEscaped(choice);
        }
        action += ")";
    }
    return ":" + zshEscaped(called) + ":" + action;
}

void writeZshOptions(std::ostream& out, const CommandWords& command, const char* indent)
{
    for (const OptionWords& option : command.options) {
        for (const std::string& name : option.names) {
            out << " \\\n"
                << indent << "'" << (option.mayRepeat ? "*" : "") << name << "[" << zshEscaped(option.help) << "]"
                << (option.isFlag() ? "" : zshValue(option, option.value.substr(0, option.value.find(':')))) << "'";
        }
    }
}

}   // namespace

std::string zshCompletionOf(const ProgramWords& program)
{
    std::ostringstream out;
    out << "#compdef angiopose-cli\n# zsh completion of angiopose-cli, written by the program itself\n"
        << "_angiopose_cli()\n{\n    local state line\n    local -a commands\n    commands=(\n";
    for (const CommandWords& command : program.commands) {
        out << "        '" << zshEscaped(command.name) << ":" << zshEscaped(command.summary) << "'\n";
    }
    out << "    )\n    _arguments -C";
    writeZshOptions(out, program.itself, "        ");
    out << " \\\n        '1: :->command' '*:: :->operands'\n    case $state in\n"
        << "        command) _describe command commands ;;\n        operands)\n            case $line[1] in\n";
    for (const CommandWords& command : program.commands) {
        out << "                " << command.name << ")\n                    _arguments";
        writeZshOptions(out, command, "                        ");
        for (const OptionWords& operand : command.operands) {
            out << " \\\n                        '" << (operand.mayRepeat ? "*" : "")
                << zshValue(operand, operand.names.front()) << "'";
        }
        out << "\n                    ;;\n";
    }
    out << "            esac\n            ;;\n    esac\n}\n_angiopose_cli \"$@\"\n";
    return out.str();
}

}   // namespace angiopose::app
