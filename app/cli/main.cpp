#include "app/cli/add_commands.h"
#include "app/cli/audit_hook.h"
#include "app/cli/console.h"
#include "app/messages/messages.h"
#include "core/support/nearest_word.h"
#include "io/support/crash_dumps.h"
#include "io/support/file_limits.h"
#include "io/support/numbers.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <clocale>
#include <cmath>
#include <exception>
#include <new>
#include <string>
#include <vector>

using namespace angiopose;

namespace {

using namespace app;

/// Makes every numeric option reject "nan" and "inf", which the range checks of CLI11 accept.
void requireFiniteNumbers(CLI::App& app)
{
    const CLI::Validator finite(
        [](std::string& text) {
            const auto number = io::parseNumber(text);
            return number && !std::isfinite(*number) ? text + " is not a finite number." : std::string();
        },
        "");
    for (CLI::Option* option : app.get_options()) {
        if (option->get_type_name().find("FLOAT") != std::string::npos) {
            option->check(finite);
        }
    }
    for (CLI::App* command : app.get_subcommands({})) {
        requireFiniteNumbers(*command);
    }
}

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

/// Translates `help` and `help COMMAND` to the equivalent options; returns other arguments unchanged. The result is in
/// reverse order, as CLI::App::parse expects it.
std::vector<std::string> helpAsOptions(std::vector<std::string> arguments)
{
    if (!arguments.empty() && arguments.front() == "help") {
        arguments.erase(arguments.begin());
        arguments.emplace_back("--help");
    }
    std::ranges::reverse(arguments);
    return arguments;
}

/// Describes a usage error, suggests what may have been meant, and refers to the help; for CLI::App::failure_message.
std::string usageHelp(const CLI::App* app, const CLI::Error& error)
{
    const auto used = app->get_subcommands();
    const CLI::App& command = used.empty() ? *app : *used.front();
    const std::string unknown = unknownWord(*app, command);
    const std::string name = used.empty() ? "" : command.get_name() + " ";
    return (unknown.empty() ? error.what() : unknown) + "\nHelp: angiopose-cli " + name + "--help\n";
}

int parseAndRun(int argc, char** argv)
{
    int exitCode = exitSuccess;
    CLI::App app("AngioPose: registers a 3-D vessel tree to a 2-D angiogram. Not for clinical use.", "angiopose-cli");
    app.set_version_flag("--version", std::string("angiopose-cli ") + ANGIOPOSE_VERSION);
    app.require_subcommand(1);
    app.footer(
        "Exit codes: 0 success, 2 usage error, 3 input missing or invalid, 4 result not reliable, 130 stopped.\nHelp "
        "on a command: angiopose-cli COMMAND --help");
    addRegister(app, exitCode);
    addTrack(app, exitCode);
    addProject(app, exitCode);
    addMovie(app, exitCode);
    addReport(app, exitCode);
    addExportDicom(app, exitCode);
    addAngles(app, exitCode);
    addMeasure(app, exitCode);
    addSimulate(app, exitCode);
    addTraceAngiogram(app, exitCode);
    addEvaluate(app, exitCode);
    addBatch(app, exitCode);
    addBatchWorker(app, exitCode);
    addTraceVessel(app, exitCode);
    addConvert(app, exitCode);
    addPack(app, exitCode);
    addStudies(app, exitCode);
    addInfo(app, exitCode);
    addValidate(app, exitCode);
    addSchema(app, exitCode);
    addThumbnail(app, exitCode);
    addDescription(app, exitCode);
    addArchive(app, exitCode);
    addSupportBundle(app, exitCode);
    addAudit(app);
    requireFiniteNumbers(app);
    app.failure_message(usageHelp);
    try {
        app.parse(helpAsOptions({argv + 1, argv + argc}));
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? exitSuccess : exitUsageError;
    }
    auditOutcome(app, exitCode);
    return exitCode;
}

}   // namespace

int main(int argc, char** argv)
{
    std::setlocale(LC_ALL, "C");
    app::installInterruptHandler();
    io::reportFileSizeLimit();
    io::enableCrashDumps("angiopose-cli");
    try {
        return app::finishOutput(parseAndRun(argc, argv));
    } catch (const std::bad_alloc&) {
        return app::reportInputError(app::messages::notEnoughMemory());
    } catch (const std::exception& error) {
        return app::reportInputError(app::messages::unexpectedFailure(error.what()));
    }
}
