#include "app/cli/batch/batch_folder.h"
#include "app/cli/batch/batch_pool.h"
#include "app/cli/commands.h"
#include "app/cli/shard.h"
#include "app/messages/messages.h"
#include "core/support/parallel_for.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>

namespace angiopose::app {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr auto tableInterval =
    std::chrono::seconds(1);   // minimum interval between rewrites of the tables, which may have thousands of rows

core::Status makeFolder(const std::string& folder)
{
    std::error_code failure;
    fs::create_directories(folder, failure);
    return failure ? core::Status(core::Error(messages::folderNotMade(folder, failure.message())))
                   : core::Status(core::Done{});
}

/// Returns the exit code of the worst outcome (from worst to best: failed, low confidence, done).
int worstExitCode(const BatchOutcomes& outcomes, const core::Shard& shard)
{
    int exitCode = exitSuccess;
    for (std::size_t i = shard.index; i < outcomes.size(); i += shard.count) {
        if (!outcomes[i] || !outcomes[i]->hasResult()) {
            return exitInputError;
        }
        exitCode = outcomes[i]->status == "done" ? exitCode : static_cast<int>(exitUnreliable);
    }
    return exitCode;
}

void printOutcome(const BatchOutcome& outcome)
{
    std::printf("%-16s %s\n", outcome.status.c_str(), outcome.name.c_str());
    std::fflush(stdout);
    for (const std::string& note : outcome.notes) {
        printMessage(outcome.name + ": warning: " + note);
    }
    if (!outcome.hasResult()) {
        printMessage(outcome.name + ": " + outcome.message);
    }
}

/// Parsed batch request.
struct BatchPlan {
    std::vector<io::BatchEntry> entries;
    io::CaseSettings settings;   ///< common to all rows
    core::Shard shard;
    std::string folder;
};

/// Runs the rows of a shard and updates their table as outcomes arrive.
class BatchRun {
public:
    BatchRun(const BatchPlan& plan, const BatchArguments& arguments)
        : plan_(plan), arguments_(arguments), outcomes_(plan.entries.size())
    {
    }

    int run()
    {
        std::vector<BatchJob> jobs = jobsToDo();
        PoolOptions options;
        const int threads = arguments_.threads.value_or(core::availableThreads());
        options.workers = std::max(1, std::min(threads, static_cast<int>(jobs.size())));
        options.threadsPerWorker = std::max(1, threads / options.workers);
        options.timeLimitSeconds = arguments_.timeLimitSeconds;
        BatchPool pool(std::move(jobs), options);
        ProgressLine progress("registering");
        const bool isWhole = pool.run([&](std::size_t job, BatchOutcome outcome) {
            printOutcome(outcome);
            outcomes_[rows_[job]] = std::move(outcome);
            ++done_;
            progress.show(static_cast<double>(done_) / static_cast<double>(rows_.size()),
                          std::to_string(done_) + " of " + std::to_string(rows_.size()) + " cases");
            keepTables();
        });
        if (const auto status = finish(); !status) {
            return reportInputError(status.error());
        }
        return isWhole ? worstExitCode(outcomes_, plan_.shard) : static_cast<int>(exitInterrupted);
    }

private:
    std::vector<BatchJob> jobsToDo()
    {
        std::vector<BatchJob> jobs;
        std::size_t kept = 0;
        for (std::size_t i = plan_.shard.index; i < plan_.entries.size(); i += plan_.shard.count) {
            BatchJob job = makeJob(plan_.entries[i], plan_.settings, plan_.folder);
            job.isResumed = arguments_.isResumed;
            job.skipImages = arguments_.skipImages;
            if (arguments_.isResumed) {
                outcomes_[i] = readOutcome(job.folder);
                if (outcomes_[i] && isUpToDate(*outcomes_[i], job.request, job.folder)) {
                    ++kept;
                    continue;
                }
                outcomes_[i].reset();
            }
            rows_.push_back(i);
            jobs.push_back(std::move(job));
        }
        if (arguments_.isResumed) {
            printMessage(std::to_string(kept) + " cases are already completed, " + std::to_string(jobs.size()) +
                         " remain.");
        }
        return jobs;
    }

    void keepTables()
    {
        if (Clock::now() < written_ + tableInterval) {
            return;
        }
        written_ = Clock::now();
        if (const auto status =
                writeTables(plan_.folder, plan_.entries, outcomes_, plan_.shard, MissingOutcomes::LeftOut);
            !status) {
            printMessage(status.error().message.text());   // not fatal: the outcomes themselves are stored
        }
    }

    /// Writes the table of this shard; the last shard to finish also writes the table of all shards.
    core::Status finish() const
    {
        if (auto status = writeTables(plan_.folder, plan_.entries, outcomes_, plan_.shard, MissingOutcomes::LeftOut);
            !status || plan_.shard.count == 1) {
            return status;
        }
        const BatchOutcomes all = readOutcomes(plan_.folder, plan_.entries, plan_.settings);
        return areComplete(all) ? writeTables(plan_.folder, plan_.entries, all, {}, MissingOutcomes::LeftOut)
                                : core::Status(core::Done{});
    }

    const BatchPlan& plan_;
    const BatchArguments& arguments_;
    BatchOutcomes outcomes_;
    std::vector<std::size_t> rows_;   ///< manifest row of each job
    std::size_t done_ = 0;
    Clock::time_point written_ = Clock::now();
};

/// Writes the tables from the stored outcomes of the shards; registers nothing.
int mergeBatch(const BatchPlan& plan, const BatchArguments& arguments)
{
    const auto merged = mergeOutcomes(arguments.mergedFolders, plan.entries);
    if (!merged) {
        return reportInputError(merged.error());
    }
    const BatchOutcomes& outcomes = merged.value();
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
        if (!outcomes[i]) {
            printMessage(plan.entries[i].name + ": " + messages::batchRowMissing().text());
        }
    }
    if (const auto status = writeTables(plan.folder, plan.entries, outcomes, {}, MissingOutcomes::Reported); !status) {
        return reportInputError(status.error());
    }
    std::printf("written        %s\n", (fs::path(plan.folder) / "summary.csv").string().c_str());
    return worstExitCode(outcomes, {});
}

}   // namespace

int runBatch(const BatchArguments& arguments)
{
    BatchPlan plan;
    const auto shard = parseShard(arguments.shard);
    if (!shard) {
        printMessage(shard.error().message.text());
        return exitUsageError;
    }
    if (const auto status = plan.settings.add(arguments.settings); !status) {
        printMessage(status.error().message.text());
        return exitUsageError;
    }
    auto entries = io::readManifest(arguments.manifestPath);
    if (!entries) {
        return reportInputError(entries.error());
    }
    plan.entries = std::move(entries).value();
    plan.shard = shard.value();
    plan.folder = arguments.outputFolder;
    if (const auto status = makeFolder(plan.folder); !status) {
        return reportInputError(status.error());
    }
    return arguments.mergedFolders.empty() ? BatchRun(plan, arguments).run() : mergeBatch(plan, arguments);
}

}   // namespace angiopose::app
