#include "app/cli/commands.h"
#include "app/cli/evaluate_own.h"
#include "app/cli/shard.h"
#include "app/messages/messages.h"
#include "core/evaluation/report/observer_report.h"
#include "core/evaluation/report/plot.h"
#include "core/evaluation/report/result_table.h"
#include "core/evaluation/run_experiment.h"
#include "io/evaluation/html_report.h"
#include "io/evaluation/run_files.h"
#include "io/evaluation/table_text.h"
#include "io/messages/messages.h"
#include "io/plot/svg_plot.h"
#include "io/support/atomic_file.h"

#include <cstdio>
#include <filesystem>
#include <thread>

namespace angiopose::app {
namespace {

namespace fs = std::filesystem;

core::Result<core::ExperimentPlan> planOf(const EvaluateArguments& arguments)
{
    core::ExperimentPlan plan;
    plan.protocol = core::findProtocol(arguments.protocol);
    auto conditions = core::parseConditions(*plan.protocol, arguments.conditions);
    if (!conditions) {
        return conditions.error();
    }
    auto evaluatedMethods = core::parseMethods(arguments.methods.empty() ? defaultMethods : arguments.methods);
    if (!evaluatedMethods) {
        return evaluatedMethods.error();
    }
    const auto shard = parseShard(arguments.shard);
    if (!shard) {
        return shard.error();
    }
    plan.conditions = std::move(conditions).value();
    plan.evaluatedMethods = std::move(evaluatedMethods).value();
    plan.shard = shard.value();
    plan.trials = arguments.trials.value_or(plan.protocol->defaultTrials);
    plan.seed = arguments.seed;
    plan.threads = arguments.threads.value_or(static_cast<int>(std::max(1U, std::thread::hardware_concurrency())));
    return plan;
}

core::Result<core::RunSet> mergedRuns(const EvaluateArguments& arguments)
{
    std::vector<core::RunSet> parts;
    for (const std::string& folder : arguments.mergedFolders) {
        auto part = io::readRuns(folder);
        if (!part) {
            return part.error();
        }
        parts.push_back(std::move(part).value());
    }
    auto runs = core::mergeRunSets(parts);
    if (runs && runs.value().protocol != arguments.protocol) {
        return core::Error(messages::mergeOfOthers(runs.value().protocol, arguments.protocol));
    }
    return runs;
}

core::Experiment runWithProgress(const core::ExperimentPlan& plan)
{
    ProgressLine progress("evaluating");
    return core::runExperiment(plan, [&progress](std::uint64_t done, std::uint64_t all) {
        progress.show(static_cast<double>(done) / static_cast<double>(all),
                      std::to_string(done) + " of " + std::to_string(all) + " trials");
        return isInterrupted() ? core::ObserverDecision::Stop : core::ObserverDecision::Continue;
    });
}

core::Status writeTables(const std::vector<core::ResultTable>& tables, const fs::path& folder)
{
    std::string markdown;
    for (const core::ResultTable& table : tables) {
        markdown += (markdown.empty() ? "" : "\n") + io::toMarkdown(table);
        if (auto status = io::writeAtomically((folder / (table.id + ".tex")).string(), io::toLatex(table)); !status) {
            return status;
        }
    }
    return io::writeAtomically((folder / "tables.md").string(), markdown);
}

core::Status writePlots(const std::vector<core::Plot>& plots, const fs::path& folder)
{
    for (const core::Plot& plot : plots) {
        if (auto status = io::writeAtomically((folder / (plot.id + ".svg")).string(), io::toSvg(plot)); !status) {
            return status;
        }
    }
    return core::Done{};
}

/// Report of an experiment for readers.
struct Report {
    std::string title;
    std::vector<core::ResultTable> tables;
    std::vector<core::Plot> plots;
};

core::Status makeFolder(const fs::path& folder)
{
    std::error_code failure;
    fs::create_directories(folder, failure);
    return failure ? core::Status(core::Error(messages::folderNotMade(folder.string(), failure.message())))
                   : core::Status(core::Done{});
}

core::Status writeReport(const Report& report, const fs::path& folder)
{
    for (const core::ResultTable& table : report.tables) {
        std::printf("%s\n", io::toPlainText(table).c_str());
    }
    if (auto status = writeTables(report.tables, folder); !status) {
        return status;
    }
    if (auto status = writePlots(report.plots, folder); !status) {
        return status;
    }
    return io::writeAtomically((folder / "report.html").string(),
                               io::htmlReport(report.title, report.tables, report.plots));
}

core::Status writeRunReport(const core::RunSet& runs, const fs::path& folder)
{
    if (auto status = makeFolder(folder); !status) {
        return status;
    }
    if (auto status = io::writeRuns(runs, folder.string()); !status) {
        return status;
    }
    return writeReport({"Evaluation: " + runs.protocol, core::makeTables(runs), core::makePlots(runs)}, folder);
}

int finishReport(const core::Status& status, const std::string& folder, int exitCode)
{
    if (!status) {
        return reportInputError(status.error());
    }
    std::printf("written        %s\n", (fs::path(folder) / "tables.md").string().c_str());
    return exitCode;
}

int runObservers(const EvaluateArguments& arguments)
{
    const auto readings = readObserverLogs(arguments.inputPaths);
    if (!readings) {
        return reportInputError(readings.error());
    }
    const Report report{"Observer agreement", core::observerTables(readings.value()),
                        core::observerPlots(readings.value())};
    if (report.tables.empty()) {
        return reportInputError(core::Error(io::messages::observerTooFew()));
    }
    core::Status status = makeFolder(arguments.outputFolder);
    if (status) {
        status = writeReport(report, arguments.outputFolder);
    }
    return finishReport(status, arguments.outputFolder, exitSuccess);
}

/// Explains why the named files are not those that the experiment requires; nullopt if they are.
std::optional<core::Message> findInputProblem(const EvaluateArguments& arguments)
{
    const std::size_t count = arguments.inputPaths.size();
    if (arguments.protocol == observerLogs) {
        return count == 0 ? std::optional<core::Message>(messages::observersNoLog()) : std::nullopt;
    }
    if (!arguments.mergedFolders.empty() || arguments.protocol != userCasesProtocol) {
        return count == 0 ? std::nullopt
                          : std::optional<core::Message>(
                                messages::inputOfExperiment(arguments.protocol, arguments.inputPaths.front()));
    }
    return count == 1 ? std::nullopt : std::optional<core::Message>(messages::ownNoManifest());
}

core::Result<core::Experiment> runExperimentOf(const EvaluateArguments& arguments)
{
    if (arguments.protocol == userCasesProtocol) {
        return evaluateUserCases(arguments);
    }
    const auto plan = planOf(arguments);
    return plan ? core::Result<core::Experiment>(runWithProgress(plan.value())) : plan.error();
}

}   // namespace

int runEvaluate(const EvaluateArguments& arguments)
{
    if (const auto problem = findInputProblem(arguments)) {
        printMessage(problem->text());
        return exitUsageError;
    }
    if (arguments.protocol == observerLogs) {
        return runObservers(arguments);
    }
    core::Experiment experiment;
    if (!arguments.mergedFolders.empty()) {
        auto runs = mergedRuns(arguments);
        if (!runs) {
            return reportInputError(runs.error());
        }
        experiment.runs = std::move(runs).value();
    } else {
        auto run = runExperimentOf(arguments);
        if (!run) {
            printMessage(run.error().message.text());
            return arguments.protocol == userCasesProtocol ? exitInputError : exitUsageError;
        }
        experiment = std::move(run).value();
    }
    if (experiment.runs.runs.empty()) {
        printMessage("No trial was completed; nothing was written.");
        return experiment.wasStopped ? exitInterrupted : exitInputError;
    }
    return finishReport(writeRunReport(experiment.runs, arguments.outputFolder), arguments.outputFolder,
                        experiment.wasStopped ? exitInterrupted : exitSuccess);
}

}   // namespace angiopose::app
