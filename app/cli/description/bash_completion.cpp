#include "app/cli/description/completions.h"

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

std::string bashOptions(const CommandWords& command)
{
    std::vector<std::string> names;
    for (const OptionWords& option : command.options) {
        names.insert(names.end(), option.names.begin(), option.names.end());
    }
    return joinedBySpaces(names);
}

std::string bashCommands(const ProgramWords& program)
{
    std::vector<std::string> names;
    for (const CommandWords& command : program.commands) {
        names.push_back(command.name);
    }
    return joinedBySpaces(names);
}

/// What follows an option that wants a value; files where nothing is said.
void writeBashValues(std::ostream& out, const CommandWords& command)
{
    for (const OptionWords& option : command.options) {
        if (option.isFlag() || option.isFile()) {
            continue;
        }
        for (const std::string& name : option.names) {
            out << "        '" << command.name << " " << name << "') values='" << joinedBySpaces(option.choices)
                << "' ;;\n";
        }
    }
}

void writeBashFlags(std::ostream& out, const CommandWords& command)
{
    for (const OptionWords& option : command.options) {
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

}   // namespace

std::string bashCompletionOf(const ProgramWords& program)
{
    std::ostringstream out;
    std::string begin = beginOfFunction;
    const std::string place = "%COMMANDS%";
    begin.replace(begin.find(place), place.size(), bashCommands(program));
    out << "# bash completion of angiopose-cli, written by the program itself\n" << begin;
    out << "        '' | help) options='" << bashOptions(program.itself) << "' ;;\n";
    for (const CommandWords& command : program.commands) {
        out << "        " << command.name << ") options='" << bashOptions(command) << "'";
        for (const OptionWords& operand : command.operands) {
            if (!operand.choices.empty()) {
                out << " operands='" << joinedBySpaces(operand.choices) << "'";
            }
        }
        out << " ;;\n";
    }
    out << "    esac\n    case \"$command $previous\" in\n";
    writeBashFlags(out, {"", {}, program.itself.options, {}, {}});
    for (const CommandWords& command : program.commands) {
        writeBashValues(out, command);
        writeBashFlags(out, command);
    }
    out << endOfFunction;
    return out.str();
}

}   // namespace angiopose::app
