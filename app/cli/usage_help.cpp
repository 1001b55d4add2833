#include "app/cli/usage_help.h"

#include "core/support/nearest_word.h"

#include <algorithm>

namespace angiopose::app {
namespace {

std::vector<std::string> commandNames(const CLI::App& app)
{
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands({})) {
        if (!command->get_group().empty()) {   // commands without a group are internal (used by package builds)
            names.push_back(command->get_name());
        }
    }
    return names;
}

std::vector<std::string> optionNames(const CLI::App& command)
{
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options({})) {
        for (const std::string& name : option->get_lnames()) {
            names.push_back("--" + name);
        }
    }
    return names;
}

std::string perhaps(const std::string& nearest)
{
    return nearest.empty() ? "" : " Did you mean " + nearest + "?";
}

/// Returns "There is no …" for the first unknown word; empty if all words are known.
std::string unknownWord(const CLI::App& app, const CLI::App& command)
{
    for (const std::string& word : command.remaining(true)) {
        if (&command == &app && !word.starts_with('-')) {
            const auto names = commandNames(app);
            std::string all;
            for (const std::string& name : names) {
                all += (all.empty() ? "" : ", ") + name;
            }
            return "Unknown command '" + word + "'." + perhaps(core::nearestWord(word, names)) + " Commands: " + all +
                   ".";
        }
        if (word.starts_with("--")) {
            const std::string name = word.substr(0, word.find('='));
            return "Unknown option " + name + "." + perhaps(core::nearestWord(name, optionNames(command)));
        }
    }
    return {};
}

}   // namespace

std::vector<std::string> helpAsOptions(std::vector<std::string> arguments)
{
    if (!arguments.empty() && arguments.front() == "help") {
        arguments.erase(arguments.begin());
        arguments.emplace_back("--help");
    }
    std::ranges::reverse(arguments);
    return arguments;
}

std::string usageHelp(const CLI::App* app, const CLI::Error& error)
{
    const auto used = app->get_subcommands();
    const CLI::App& command = used.empty() ? *app : *used.front();
    const std::string unknown = unknownWord(*app, command);
    const std::string name = used.empty() ? "" : command.get_name() + " ";
    return (unknown.empty() ? error.what() : unknown) + "\nHelp: angiopose-cli " + name + "--help\n";
}

}   // namespace angiopose::app
