#include "app/cli/add_commands.h"

#include "app/cli/description/command_help.h"

#include <cstdio>
#include <map>
#include <memory>

namespace angiopose::app {
namespace {

using Writer = std::string (*)(const ProgramHelp&);

const std::map<std::string, Writer>& writers()
{
    static const std::map<std::string, Writer> all{{"man", makeManPage},
                                                   {"markdown", makeMarkdownPage},
                                                   {"bash", makeBashCompletion},
                                                   {"zsh", makeZshCompletion},
                                                   {"fish", makeFishCompletion}};
    return all;
}

}   // namespace

void addDescription(CLI::App& app, int& exitCode)
{
    CLI::App* command =
        app.add_subcommand("description", "Print the man page, the page of the manual, or a shell completion script");
    command->group("");
    auto kind = std::make_shared<std::string>();
    command->add_option("KIND", *kind, "Document to print")
        ->required()
        ->check(CLI::IsMember({"man", "markdown", "bash", "zsh", "fish"}));
    command->callback([&app, &exitCode, kind] {
        std::fputs(writers().at(*kind)(collectHelp(app)).c_str(), stdout);
        exitCode = 0;
    });
}

}   // namespace angiopose::app
