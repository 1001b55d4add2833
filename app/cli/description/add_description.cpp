#include "app/cli/add_commands.h"

#include "app/cli/description/command_words.h"

#include <cstdio>
#include <map>
#include <memory>

namespace angiopose::app {
namespace {

using Writer = std::string (*)(const ProgramWords&);

const std::map<std::string, Writer>& writers()
{
    static const std::map<std::string, Writer> all{{"man", manPageOf},
                                                   {"markdown", commandPageOf},
                                                   {"bash", bashCompletionOf},
                                                   {"zsh", zshCompletionOf},
                                                   {"fish", fishCompletionOf}};
    return all;
}

}   // namespace

void addDescription(CLI::App& app, int& exitCode)
{
    CLI::App* command =
        app.add_subcommand("description", "Print the man page, the manual page or a shell completion script");
    command->group("");
    auto kind = std::make_shared<std::string>();
    command->add_option("KIND", *kind, "Document to print")
        ->required()
        ->check(CLI::IsMember({"man", "markdown", "bash", "zsh", "fish"}));
    command->callback([&app, &exitCode, kind] {
        std::fputs(writers().at(*kind)(wordsOf(app)).c_str(), stdout);
        exitCode = 0;
    });
}

}   // namespace angiopose::app
