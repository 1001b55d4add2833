#include "app/cli/add_commands.h"
#include "app/cli/audit_hook.h"
#include "app/cli/console.h"
#include "app/cli/usage_help.h"
#include "app/messages/messages.h"
#include "io/support/crash_dumps.h"
#include "io/support/file_limits.h"
#include "io/support/numbers.h"

#include <CLI/CLI.hpp>
#include <clocale>
#include <cmath>
#include <exception>
#include <iostream>

using namespace angiopose;

namespace {

using namespace app;

/// Rejects "nan" and "inf" for every numeric option, since the range checks of CLI11 accept them.
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
