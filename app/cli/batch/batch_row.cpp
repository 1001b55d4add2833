#include "app/cli/batch/batch_row.h"

#include "app/cli/case_input.h"
#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "app/cli/open_pair.h"
#include "app/cli/register_case.h"
#include "app/cli/register_outputs.h"
#include "app/messages/messages.h"
#include "core/support/parallel_for.h"
#include "core/support/stopwatch.h"
#include "core/support/utc_time.h"
#include "io/case/load_case_with_options.h"
#include "io/opening/open_case_with_options.h"
#include "io/support/system/lockable_file.h"
#include "io/support/system/worker_process.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <filesystem>
#include <new>
#include <thread>

namespace angiopose::app {
namespace {

namespace fs = std::filesystem;

core::ObserverDecision goOnUnlessStopped(double)
{
    return isInterrupted() ? core::ObserverDecision::Stop : core::ObserverDecision::Continue;
}

core::Result<core::Case> openRow(const BatchJob& job, core::Messages& warnings)
{
    io::CaseSettings settings;
    if (const auto status = settings.add(job.settings); !status) {
        return status.error();
    }
    auto opened = job.casePath.empty()
                      ? openPair({job.vesselsPath, job.angiogramPath}, settings, warnings, goOnUnlessStopped)
                      : io::openCaseWithOptions({settings, io::PeakFrameSearch::Skipped}, job.casePath, warnings,
                                                goOnUnlessStopped);
    if (!opened) {
        return opened.error();
    }
    auto moved =
        selectFrame(std::move(opened).value(), job.frame, job.casePath.empty() ? job.angiogramPath : job.casePath);
    if (!moved) {
        return moved.error();
    }
    core::Case session = std::move(moved).value();
    RegisterArguments arguments;
    arguments.method = job.method;
    if (const auto status = applyArguments(session, arguments); !status) {
        return status.error();
    }
    return session;
}

/// Lists the input files of the row. If the case cannot be opened, lists the files that the row names.
std::vector<io::InputFingerprint> inputsOf(const BatchJob& job, const core::Case* opened)
{
    std::vector<core::InputFile> files;
    if (opened) {
        files = io::inputFilesOf(*opened);
    } else if (!job.casePath.empty()) {
        for (const std::string& path : io::referencedPaths(job.casePath)) {
            files.push_back({path, {}});
        }
    }
    for (const std::string& path : {job.casePath, job.vesselsPath, job.angiogramPath}) {
        const bool isListed = std::ranges::find(files, path, &core::InputFile::path) != files.end();
        if (!path.empty() && !isListed) {
            files.push_back({path, {}});
        }
    }
    std::vector<io::InputFingerprint> facts;
    for (const core::InputFile& file : files) {
        facts.push_back(io::inputFingerprint(file.path, file.sha256));
    }
    return facts;
}

std::vector<WrittenFile> filesIn(const std::string& folder)
{
    std::vector<WrittenFile> files;
    for (const std::string& path : listOutputs(folder)) {
        std::error_code failed;
        files.push_back({path, fs::file_size(fs::path(folder) / path, failed)});
    }
    return files;
}

core::Status registerOpened(BatchOutcome& outcome, const BatchJob& job, core::Case session)
{
    auto registered = registerWithoutProgress(std::move(session), {.readMs = outcome.times.readMs});
    if (!registered) {
        return registered.error();
    }
    if (isInterrupted()) {
        return core::Done{};
    }
    core::Stopwatch watch;
    if (auto status = writeOutputs(registered.value(), job.folder,
                                   job.skipImages ? OverlayImages::LeftOut : OverlayImages::Drawn);
        !status) {
        return status;
    }
    addResult(outcome, registered.value());
    outcome.times.writeMs = watch.takeLapMs();
    return core::Done{};
}

core::Status openAndRegister(BatchOutcome& outcome, const BatchJob& job)
{
    core::Stopwatch watch;
    core::Messages warnings;
    auto opened = openRow(job, warnings);
    outcome.times.readMs = watch.takeLapMs();
    for (const core::Message& warning : warnings) {
        outcome.notes.push_back(warning.text());
    }
    outcome.inputs = inputsOf(job, opened ? &opened.value() : nullptr);
    return opened ? registerOpened(outcome, job, std::move(opened).value()) : core::Status(opened.error());
}

void fail(BatchOutcome& outcome, const core::Message& problem)
{
    outcome.status = "failed";
    outcome.message = problem.text();
}

/// Creates an outcome without results.
BatchOutcome makeOutcome(const BatchJob& job)
{
    BatchOutcome outcome;
    outcome.name = job.name;
    outcome.method = job.method;
    outcome.request = job.request;
    return outcome;
}

/// Waits until no other process writes to the folder; the outcome of that process can then be read there.
void waitForTurn(const io::LockableFile& folder)
{
    using namespace std::chrono_literals;
    while (folder.isOpen() && folder.lockExclusive() == io::LockableFile::LockState::HeldByOther && !isInterrupted()) {
        std::this_thread::sleep_for(20ms);
    }
}

/// Registers one batch row, with all views of its case jointly, and writes the outputs of `register` to the folder of
/// the row, the outcome last. Any failure becomes the outcome. Returns nullopt if canceled; the files written so far
/// are then not an outcome.
std::optional<BatchOutcome> processRow(const BatchJob& job)
{
    BatchOutcome outcome = makeOutcome(job);
    std::error_code failure;
    fs::create_directories(job.folder, failure);
    if (failure) {
        fail(outcome, messages::folderNotMade(job.folder, failure.message()));
        return outcome;
    }
    const io::LockableFile folder(job.folder, io::LockableFile::OpenMode::Folder);
    waitForTurn(folder);
    if (job.resumes) {
        if (auto known = readOutcome(job.folder); known && isUpToDate(*known, job.request, job.folder)) {
            return known;
        }
    }
    removeOutputs(job.folder);
    try {
        if (const core::Status status = openAndRegister(outcome, job); !status) {
            fail(outcome, status.error().message);
        }
    } catch (const std::bad_alloc&) {
        fail(outcome, messages::notEnoughMemory());
    } catch (const std::exception& error) {
        fail(outcome, messages::unexpectedFailure(error.what()));
    }
    if (isInterrupted()) {
        removeOutputs(job.folder);
        return std::nullopt;
    }
    outcome.files = filesIn(job.folder);
    outcome.times.finished = core::utcNow();
    if (const core::Status kept = writeOutcome(outcome, job.folder); !kept) {
        fail(outcome, kept.error().message);
    }
    return outcome;
}

}   // namespace

BatchOutcome makeAbandonedOutcome(const BatchJob& job, const std::string& status, const core::Message& reason)
{
    BatchOutcome outcome = makeOutcome(job);
    outcome.status = status;
    outcome.message = reason.text();
    outcome.inputs = inputsOf(job, nullptr);
    outcome.times.finished = core::utcNow();
    removeOutputs(job.folder);
    if (const core::Status kept = writeOutcome(outcome, job.folder); !kept) {
        printMessage(kept.error().message.text());
    }
    return outcome;
}

int runBatchWorker(int parent, int threads)
{
    if (!io::WorkerChannel::open(parent)) {
        printMessage("batch-worker is internal and is started only by `batch`.");
        return exitUsageError;
    }
    core::limitThreads(threads);
    for (std::string line; io::WorkerChannel::receiveLine(line, isInterrupted);) {
        const auto outcome = processRow(parseJob(line));
        if (!outcome || !io::WorkerChannel::sendLine(toJsonLine(*outcome))) {
            return exitInterrupted;
        }
    }
    return exitSuccess;
}

}   // namespace angiopose::app
