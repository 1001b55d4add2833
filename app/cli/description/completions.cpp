#include "app/cli/description/command_help.h"

#include <sstream>

namespace angiopose::app {
namespace {

std::string joinedBySpaces(const std::vector<std::string>& words)
{
    std::string text;
    for (const std::string& word : words) {
        text += (text.empty() ? "" : " ") + word;
    }
    return text;
}

std::string bashOptions(const CommandHelp& command)
{
    std::vector<std::string> names;
    for (const OptionHelp& option : command.options) {
        names.insert(names.end(), option.names.begin(), option.names.end());
    }
    return joinedBySpaces(names);
}

std::string bashCommands(const ProgramHelp& program)
{
    std::vector<std::string> names;
    for (const CommandHelp& command : program.commands) {
        names.push_back(command.name);
    }
    return joinedBySpaces(names);
}

/// Writes the completions for options with a value, which are files for options without known choices.
void writeBashValues(std::ostream& out, const CommandHelp& command)
{
    for (const OptionHelp& option : command.options) {
        if (option.isFlag() || option.isFile()) {
            continue;
        }
        for (const std::string& name : option.names) {
            out << "        '" << command.name << " " << name << "') values='" << joinedBySpaces(option.choices)
                << "' ;;\n";
        }
    }
}

void writeBashFlags(std::ostream& out, const CommandHelp& command)
{
    for (const OptionHelp& option : command.options) {
        for (const std::string& name : option.names) {
            if (option.isFlag()) {
                out << "        '" << command.name << " " << name << "') previous= ;;\n";
            }
        }
    }
}

constexpr const char* beginOfFunction = R"(_angiopose_cli()
{
    local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]} command='' options='' operands='' i
    local values=files commands='%COMMANDS%'
    if [[ $current == = ]]; then
        current=
    elif [[ $previous == = && $COMP_CWORD -gt 1 ]]; then
        previous=${COMP_WORDS[COMP_CWORD-2]}
    fi
    COMPREPLY=()
    for ((i = 1; i < COMP_CWORD; i++)); do
        if [[ " help $commands " == *" ${COMP_WORDS[i]} "* ]]; then
            command=${COMP_WORDS[i]}
            break
        fi
    done
    case $command in
)";

constexpr const char* endOfFunction = R"(    esac
    if [[ $previous != -* ]]; then
        values=
        if [[ $current == -* ]]; then
            values=$options
        elif [[ -z $command || $command == help ]]; then
            values=$commands
        elif [[ -n $operands ]]; then
            values=$operands
        else
            values=files
        fi
    fi
    if [[ $values == files ]]; then
        compopt -o filenames 2>/dev/null
        mapfile -t COMPREPLY < <(compgen -f -- "$current")
    elif [[ -n $values ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$values" -- "$current")
        [[ ${COMPREPLY[0]} == *= ]] && compopt -o nospace 2>/dev/null
    fi
    return 0
}
complete -F _angiopose_cli angiopose-cli
)";

std::string fishQuoted(const std::string& text)
{
    std::string out;
    for (const char sign : text) {
        out += sign == '\'' || sign == '\\' ? std::string("\\") + sign : std::string(1, sign);
    }
    return "'" + out + "'";
}

void writeFishOption(std::ostream& out, const std::string& condition, const OptionHelp& option)
{
    out << "complete -c angiopose-cli -n " << fishQuoted(condition);
    for (const std::string& name : option.names) {
        out << (name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1));
    }
    if (!option.choices.empty()) {
        out << " -x -a " << fishQuoted(joinedBySpaces(option.choices));
    } else if (!option.isFlag()) {
        out << (option.isFile() ? " -r -F" : " -x");
    }
    out << " -d " << fishQuoted(option.help) << "\n";
}

/// Escapes text for a single-quoted field of zsh, which an unescaped colon or bracket would end.
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

/// Returns the completion of a value, e.g. ":TEXT:(a b)".
std::string zshValue(const OptionHelp& option, const std::string& called)
{
    std::string action = option.isFile() ? "_files" : " ";
    if (!option.choices.empty()) {
        action = "(" + zshEscaped(joinedBySpaces(option.choices)) + ")";
    }
    return ":" + zshEscaped(called) + ":" + action;
}

void writeZshOptions(std::ostream& out, const CommandHelp& command, const char* indent)
{
    for (const OptionHelp& option : command.options) {
        for (const std::string& name : option.names) {
            out << " \\\n"
                << indent << "'" << (option.mayRepeat ? "*" : "") << name << "[" << zshEscaped(option.help) << "]"
                << (option.isFlag() ? "" : zshValue(option, option.value.substr(0, option.value.find(':')))) << "'";
        }
    }
}

}   // namespace

std::string makeBashCompletion(const ProgramHelp& program)
{
    std::ostringstream out;
    std::string begin = beginOfFunction;
    const std::string place = "%COMMANDS%";
    begin.replace(begin.find(place), place.size(), bashCommands(program));
    out << "# bash completion for angiopose-cli, generated by the program\n" << begin;
    out << "        '' | help) options='" << bashOptions(program.mainCommand) << "' ;;\n";
    for (const CommandHelp& command : program.commands) {
        out << "        " << command.name << ") options='" << bashOptions(command) << "'";
        for (const OptionHelp& operand : command.operands) {
            if (!operand.choices.empty()) {
                out << " operands='" << joinedBySpaces(operand.choices) << "'";
            }
        }
        out << " ;;\n";
    }
    out << "    esac\n    case \"$command $previous\" in\n";
    writeBashFlags(out, {"", {}, program.mainCommand.options, {}, {}});
    for (const CommandHelp& command : program.commands) {
        writeBashValues(out, command);
        writeBashFlags(out, command);
    }
    out << endOfFunction;
    return out.str();
}

std::string makeFishCompletion(const ProgramHelp& program)
{
    std::ostringstream out;
    out << "# fish completion for angiopose-cli, generated by the program\n";
    for (const OptionHelp& option : program.mainCommand.options) {
        writeFishOption(out, "__fish_use_subcommand", option);
    }
    for (const CommandHelp& command : program.commands) {
        out << "complete -c angiopose-cli -n __fish_use_subcommand -f -a " << command.name << " -d "
            << fishQuoted(command.summary) << "\n";
        const std::string condition = "__fish_seen_subcommand_from " + command.name;
        for (const OptionHelp& operand : command.operands) {
            if (!operand.choices.empty()) {
                out << "complete -c angiopose-cli -n " << fishQuoted(condition) << " -f -a "
                    << fishQuoted(joinedBySpaces(operand.choices)) << "\n";
            }
        }
        for (const OptionHelp& option : command.options) {
            writeFishOption(out, condition, option);
        }
    }
    return out.str();
}

std::string makeZshCompletion(const ProgramHelp& program)
{
    std::ostringstream out;
    out << "#compdef angiopose-cli\n# zsh completion for angiopose-cli, generated by the program\n"
        << "_angiopose_cli()\n{\n    local state line\n    local -a commands\n    commands=(\n";
    for (const CommandHelp& command : program.commands) {
        out << "        '" << zshEscaped(command.name) << ":" << zshEscaped(command.summary) << "'\n";
    }
    out << "    )\n    _arguments -C";
    writeZshOptions(out, program.mainCommand, "        ");
    out << " \\\n        '1: :->command' '*:: :->operands'\n    case $state in\n"
        << "        command) _describe command commands ;;\n        operands)\n            case $line[1] in\n";
    for (const CommandHelp& command : program.commands) {
        out << "                " << command.name << ")\n                    _arguments";
        writeZshOptions(out, command, "                        ");
        for (const OptionHelp& operand : command.operands) {
            out << " \\\n                        '" << (operand.mayRepeat ? "*" : "")
                << zshValue(operand, operand.names.front()) << "'";
        }
        out << "\n                    ;;\n";
    }
    out << "            esac\n            ;;\n    esac\n}\n_angiopose_cli \"$@\"\n";
    return out.str();
}

}   // namespace angiopose::app
