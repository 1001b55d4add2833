#include "app/cli/batch/batch_job.h"
#include "app/cli/batch/batch_outcome.h"
#include "app/cli/batch/batch_pool.h"
#include "app/cli/commands.h"
#include "app/cli/shard.h"
#include "app/messages/messages.h"
#include "core/evaluation/run_experiment.h"
#include "core/support/format_number.h"
#include "core/support/parallel_for.h"
#include "core/support/result.h"
#include "io/case/batch_manifest.h"
#include "io/case/case_settings.h"
#include "io/support/atomic_file.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace angiopose::app {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr auto tableInterval =
    std::chrono::seconds(1);   // minimum interval between rewrites of the tables, which can have thousands of rows

/// Outcomes in the order of the rows in the manifest; nullopt where unknown.
using BatchOutcomes = std::vector<std::optional<BatchOutcome>>;

enum class MissingOutcomes { LeftOut, Reported };

// Writes the batch tables as CSV (RFC 4180).

std::string quoted(const std::string& text)
{
    std::string result = "\"";
    for (const char c : text) {
        result += c == '"' ? std::string("\"\"") : c == '\n' ? std::string(" ") : std::string(1, c);
    }
    return result + "\"";
}

std::string milliseconds(double value)
{
    return std::isfinite(value) ? "," + core::fixedText(value, 1) : ",";
}

/// Return columns of reproducible results: header row, and row of one case (`outcome` is null if it is missing).
std::string summaryHeader()
{
    std::string header = "row,name,case,status,method,views";
    for (const std::string_view name : figureNames()) {
        header += "," + std::string(name);
    }
    return header + ",message\n";
}

std::string summaryRow(const io::BatchEntry& entry, const BatchOutcome* outcome)
{
    std::string row = std::to_string(entry.row) + "," + quoted(entry.name) + "," +
                      quoted(entry.caseCell.empty() ? entry.angiogramCell : entry.caseCell) + "," +
                      (outcome ? outcome->status : "missing") + "," + (outcome ? outcome->method : entry.method) + ",";
    row += outcome && outcome->hasResult() ? std::to_string(outcome->viewCount) : "";
    for (std::size_t i = 0; i < figureNames().size(); ++i) {
        const bool isKnown = outcome && i < outcome->figures.size();
        row += "," + (isKnown ? core::plainText(outcome->figures[i]) : std::string());
    }
    return row + "," + quoted(outcome ? outcome->message : messages::batchRowMissing().text()) + "\n";
}

/// Return the columns of computing times, which differ between runs.
std::string timesHeader()
{
    return "row,name,read_ms,trace_ms,register_ms,write_ms,finished\n";
}

std::string timesRow(const io::BatchEntry& entry, const BatchOutcome& outcome)
{
    const BatchTimes& times = outcome.times;
    return std::to_string(entry.row) + "," + quoted(entry.name) + milliseconds(times.readMs) +
           milliseconds(times.traceMs) + milliseconds(times.registerMs) + milliseconds(times.writeMs) + "," +
           times.finished + "\n";
}

std::string folderOf(const std::string& output, const io::BatchEntry& entry)
{
    return (fs::path(output) / entry.name).string();
}

/// Returns the path of a table. Each shard has its own, since shards may share a folder.
std::string tablePath(const std::string& folder, const std::string& stem, const core::Shard& shard)
{
    const std::string part =
        shard.count == 1 ? "" : "-" + std::to_string(shard.index + 1) + "-of-" + std::to_string(shard.count);
    return (fs::path(folder) / (stem + part + ".csv")).string();
}

/// Reads the stored outcomes in a results folder that match these rows and common settings.
BatchOutcomes readOutcomes(const std::string& folder, const std::vector<io::BatchEntry>& entries,
                           const io::CaseSettings& common)
{
    BatchOutcomes outcomes;
    for (const io::BatchEntry& entry : entries) {
        auto found = readOutcome(folderOf(folder, entry));
        const std::string request = serializeRequest(entry, common);
        if (found && !(isSameRow(found->request, request) && haveSameSettings(found->request, request))) {
            found.reset();
        }
        outcomes.push_back(std::move(found));
    }
    return outcomes;
}

/// Reads the stored outcomes in several folders, whatever their common settings. If the folders differ in these
/// settings, fails and names two that do.
core::Result<BatchOutcomes> mergeOutcomes(const std::vector<std::string>& folders,
                                          const std::vector<io::BatchEntry>& entries)
{
    BatchOutcomes outcomes(entries.size());
    const BatchOutcome* first = nullptr;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const std::string request = serializeRequest(entries[i], {});
        for (const std::string& folder : folders) {
            auto found = readOutcome(folderOf(folder, entries[i]));
            if (!found || !isSameRow(found->request, request)) {
                continue;
            }
            const bool isOther =
                outcomes[i] && summaryRow(entries[i], &*found) != summaryRow(entries[i], &*outcomes[i]);
            if (isOther || (first && !haveSameSettings(first->request, found->request))) {
                return core::Error(
                    messages::batchMergeDiffers((isOther ? *outcomes[i] : *first).name, folderOf(folder, entries[i])));
            }
            outcomes[i] = std::move(found);
            first = first ? first : &*outcomes[i];
        }
    }
    return outcomes;
}

bool areComplete(const BatchOutcomes& outcomes)
{
    return std::ranges::all_of(outcomes, [](const auto& outcome) { return outcome.has_value(); });
}

/// Writes summary.csv and times.csv for the rows of a shard, or summary-I-of-N.csv and times-I-of-N.csv if there are
/// several shards.
core::Status writeTables(const std::string& folder, const std::vector<io::BatchEntry>& entries,
                         const BatchOutcomes& outcomes, const core::Shard& shard, MissingOutcomes missing)
{
    std::string summary = summaryHeader();
    std::string times = timesHeader();
    for (std::size_t i = shard.index; i < entries.size(); i += shard.count) {
        if (outcomes[i]) {
            summary += summaryRow(entries[i], &*outcomes[i]);
            times += timesRow(entries[i], *outcomes[i]);
        } else if (missing == MissingOutcomes::Reported) {
            summary += summaryRow(entries[i], nullptr);
        }
    }
    if (auto status = io::writeAtomically(tablePath(folder, "summary", shard), summary); !status) {
        return status;
    }
    return io::writeAtomically(tablePath(folder, "times", shard), times);
}

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
    io::CaseSettings settings;   ///< settings common to all rows
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
            job.resumes = arguments_.resumes;
            job.skipImages = arguments_.skipImages;
            if (arguments_.resumes) {
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
        if (arguments_.resumes) {
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
    std::vector<std::size_t> rows_;   ///< row in the manifest of each job
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
