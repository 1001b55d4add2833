#include "app/cli/commands.h"
#include "app/cli/shard.h"
#include "app/messages/says.h"
#include "core/evaluation/report/plot.h"
#include "core/evaluation/report/result_table.h"
#include "core/evaluation/run_experiment.h"
#include "io/evaluation/run_files.h"
#include "io/evaluation/table_text.h"
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
    auto conditions = core::conditionsFrom(*plan.protocol, arguments.conditions);
    if (!conditions) {
        return conditions.error();
    }
    auto contestants = core::contestantsFrom(arguments.methods);
    if (!contestants) {
        return contestants.error();
    }
    const auto shard = shardFrom(arguments.shard);
    if (!shard) {
        return shard.error();
    }
    plan.conditions = std::move(conditions).value();
    plan.contestants = std::move(contestants).value();
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
    auto runs = core::merged(parts);
    if (runs && runs.value().protocol != arguments.protocol) {
        return core::Error(says::mergeOfOthers(runs.value().protocol, arguments.protocol));
    }
    return runs;
}

core::Experiment runWithProgress(const core::ExperimentPlan& plan)
{
    ProgressLine progress("evaluating");
    return core::runExperiment(plan, [&progress](std::uint64_t done, std::uint64_t all) {
        progress.show(static_cast<double>(done) / static_cast<double>(all),
                      std::to_string(done) + " of " + std::to_string(all) + " trials");
        return isInterrupted() ? core::Verdict::Stop : core::Verdict::Continue;
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

core::Status writeReport(const core::RunSet& runs, const fs::path& folder)
{
    std::error_code failure;
    fs::create_directories(folder, failure);
    if (failure) {
        return core::Error(says::folderNotMade(folder.string(), failure.message()));
    }
    if (auto status = io::writeRuns(runs, folder.string()); !status) {
        return status;
    }
    const std::vector<core::ResultTable> tables = core::tablesOf(runs);
    for (const core::ResultTable& table : tables) {
        std::printf("%s\n", io::toPlainText(table).c_str());
    }
    if (auto status = writeTables(tables, folder); !status) {
        return status;
    }
    return writePlots(core::plotsOf(runs), folder);
}

}   // namespace

int runEvaluate(const EvaluateArguments& arguments)
{
    core::Experiment experiment;
    if (!arguments.mergedFolders.empty()) {
        auto runs = mergedRuns(arguments);
        if (!runs) {
            return failInput(runs.error());
        }
        experiment.runs = std::move(runs).value();
    } else {
        const auto plan = planOf(arguments);
        if (!plan) {
            printMessage(plan.error().message.text());
            return exitUsage;
        }
        experiment = runWithProgress(plan.value());
    }
    if (experiment.runs.runs.empty()) {
        printMessage("No trial was finished: nothing is written.");
        return experiment.wasStopped ? exitStopped : exitInput;
    }
    if (const auto status = writeReport(experiment.runs, arguments.outputFolder); !status) {
        return failInput(status.error());
    }
    std::printf("written        %s\n", (fs::path(arguments.outputFolder) / "tables.md").string().c_str());
    return experiment.wasStopped ? exitStopped : exitDone;
}

}   // namespace angiopose::app