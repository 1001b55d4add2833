#include "app/cli/description/command_help.h"

#include "core/geometry/pose_axis.h"
#include "core/registration/methods/method_info.h"
#include "core/registration/options/option_fields.h"

#include <algorithm>

namespace angiopose::app {
namespace {

std::vector<std::string> splitAtCommas(const std::string& text)
{
    std::vector<std::string> parts;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        parts.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return parts;
}

/// Lists the allowed values of options that the program validates itself, so CLI11 does not know them.
std::vector<std::string> allowedValuesOf(const std::string& name)
{
    std::vector<std::string> choices;
    if (name == "--method") {
        for (const core::MethodInfo& method : core::methodInfos()) {
            choices.emplace_back(method.id);
        }
    } else if (name == "--set") {
        for (const core::OptionField& field : core::optionFields()) {
            choices.push_back(std::string(field.key) + "=");
        }
    } else if (name == "--lock") {
        choices = splitAtCommas(core::poseAxisIds());
        for (std::string& axis : choices) {
            axis.erase(0, axis.find_first_not_of(' '));
        }
        choices.emplace_back("none");
    }
    return choices;
}

/// Parses the allowed values, which CLI11 formats as "TEXT:{minimum,maximum}".
std::vector<std::string> choicesIn(const std::string& value)
{
    const std::size_t open = value.find('{');
    const std::size_t close = value.rfind('}');
    return open == std::string::npos || close == std::string::npos
               ? std::vector<std::string>{}
               : splitAtCommas(value.substr(open + 1, close - open - 1));
}

/// Removes a repeated type name, e.g. from "INT:INT in [1 - 9]".
std::string withoutRepeatedType(const std::string& value)
{
    const std::size_t colon = value.find(':');
    const std::string type = value.substr(0, colon);
    return colon != std::string::npos && value.substr(colon + 1).starts_with(type + " ") ? value.substr(colon + 1)
                                                                                         : value;
}

OptionHelp wordsOfOption(const CLI::Option& option)
{
    OptionHelp words;
    for (const std::string& name : option.get_snames()) {
        words.names.push_back("-" + name);
    }
    for (const std::string& name : option.get_lnames()) {
        words.names.push_back("--" + name);
    }
    if (option.get_positional()) {
        words.names = {option.get_name(true)};
    }
    if (option.get_items_expected_max() != 0) {
        words.value = withoutRepeatedType(option.get_type_name());
    }
    words.help = option.get_description();
    words.choices = choicesIn(words.value);
    if (words.choices.empty()) {
        words.choices = allowedValuesOf(words.names.back());
    }
    words.isRequired = option.get_required();
    words.mayRepeat = option.get_expected_max() > 1;
    return words;
}

CommandHelp wordsOfCommand(const CLI::App& command)
{
    CommandHelp words{command.get_name(), command.get_description(), {}, {}, command.get_footer()};
    for (const CLI::Option* option : command.get_options()) {
        if (!option->get_group().empty()) {
            (option->get_positional() ? words.operands : words.options).push_back(wordsOfOption(*option));
        }
    }
    return words;
}

}   // namespace

ProgramHelp collectHelp(const CLI::App& app)
{
    ProgramHelp words{wordsOfCommand(app), {}};
    for (const CLI::App* command : app.get_subcommands(nullptr)) {
        if (!command->get_group().empty()) {
            words.commands.push_back(wordsOfCommand(*command));
        }
    }
    return words;
}

}   // namespace angiopose::app
