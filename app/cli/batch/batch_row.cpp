#include "app/cli/batch/batch_row.h"

#include "app/cli/case_input.h"
#include "app/cli/console.h"
#include "app/cli/open_together.h"
#include "app/cli/register_case.h"
#include "app/cli/register_outputs.h"
#include "app/messages/messages.h"
#include "core/support/stopwatch.h"
#include "core/support/utc_time.h"
#include "io/case/load_case_with.h"
#include "io/opening/open_case_with.h"
#include "io/support/system/held_file.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <new>
#include <thread>

namespace angiopose::app {
namespace {

namespace fs = std::filesystem;

core::Verdict goOnUnlessStopped(double)
{
    return isInterrupted() ? core::Verdict::Stop : core::Verdict::Continue;
}

core::Result<core::Case> openRow(const BatchJob& job, core::Messages& warnings)
{
    io::CaseSettings settings;
    if (const auto status = settings.add(job.settings); !status) {
        return status.error();
    }
    auto opened =
        job.casePath.empty()
            ? openTogether({job.vesselsPath, job.angiogramPath}, settings, warnings, goOnUnlessStopped)
            : io::openCaseWith({settings, io::PeakFrame::NotNeeded}, job.casePath, warnings, goOnUnlessStopped);
    if (!opened) {
        return opened.error();
    }
    auto moved = atFrame(std::move(opened).value(), job.frame, job.casePath.empty() ? job.angiogramPath : job.casePath);
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

/// Lists the input files of the row. If the case could not be opened, lists the files that the row names.
std::vector<io::InputFacts> inputsOf(const BatchJob& job, const core::Case* opened)
{
    std::vector<core::InputFile> files;
    if (opened) {
        files = io::filesOf(*opened);
    } else if (!job.casePath.empty()) {
        for (const std::string& path : io::filesNamedIn(job.casePath)) {
            files.push_back({path, {}});
        }
    }
    for (const std::string& path : {job.casePath, job.vesselsPath, job.angiogramPath}) {
        const bool isListed = std::ranges::find(files, path, &core::InputFile::path) != files.end();
        if (!path.empty() && !isListed) {
            files.push_back({path, {}});
        }
    }
    std::vector<io::InputFacts> facts;
    for (const core::InputFile& file : files) {
        facts.push_back(io::factsOfInput(file.path, file.sha256));
    }
    return facts;
}

std::vector<WrittenFile> filesIn(const std::string& folder)
{
    std::vector<WrittenFile> files;
    for (const std::string& path : outputFilesIn(folder)) {
        std::error_code failed;
        files.push_back({path, fs::file_size(fs::path(folder) / path, failed)});
    }
    return files;
}

core::Status registerOpened(BatchOutcome& outcome, const BatchJob& job, core::Case session)
{
    auto registered = registerQuietly(std::move(session), {.readMs = outcome.times.readMs});
    if (!registered) {
        return registered.error();
    }
    if (isInterrupted()) {
        return core::Done{};
    }
    core::Stopwatch watch;
    if (auto status =
            writeOutputs(registered.value(), job.folder, job.isWithoutPictures ? Pictures::LeftOut : Pictures::Drawn);
        !status) {
        return status;
    }
    addResult(outcome, registered.value());
    outcome.times.writeMs = watch.lapMs();
    return core::Done{};
}

core::Status openAndRegister(BatchOutcome& outcome, const BatchJob& job)
{
    core::Stopwatch watch;
    core::Messages warnings;
    auto opened = openRow(job, warnings);
    outcome.times.readMs = watch.lapMs();
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
BatchOutcome begunOutcome(const BatchJob& job)
{
    BatchOutcome outcome;
    outcome.name = job.name;
    outcome.method = job.method;
    outcome.asked = job.asked;
    return outcome;
}

/// Waits until no other process writes into the folder; the outcome of that process can then be read from the folder.
void waitForTurn(const io::HeldFile& folder)
{
    using namespace std::chrono_literals;
    while (folder.isOpen() && folder.holdAlone() == io::HeldFile::Held::ByAnother && !isInterrupted()) {
        std::this_thread::sleep_for(20ms);
    }
}

}   // namespace

std::optional<BatchOutcome> doRow(const BatchJob& job)
{
    BatchOutcome outcome = begunOutcome(job);
    std::error_code failure;
    fs::create_directories(job.folder, failure);
    if (failure) {
        fail(outcome, messages::folderNotMade(job.folder, failure.message()));
        return outcome;
    }
    const io::HeldFile folder(job.folder, io::HeldFile::Way::Folder);
    waitForTurn(folder);
    if (job.isResumed) {
        if (auto known = readOutcome(job.folder); known && isUpToDate(*known, job.asked, job.folder)) {
            return known;
        }
    }
    removeOutputsIn(job.folder);
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
        removeOutputsIn(job.folder);
        return std::nullopt;
    }
    outcome.files = filesIn(job.folder);
    outcome.times.finished = core::utcNow();
    if (const core::Status kept = writeOutcome(outcome, job.folder); !kept) {
        fail(outcome, kept.error().message);
    }
    return outcome;
}

BatchOutcome abandonedRow(const BatchJob& job, const std::string& status, const core::Message& why)
{
    BatchOutcome outcome = begunOutcome(job);
    outcome.status = status;
    outcome.message = why.text();
    outcome.inputs = inputsOf(job, nullptr);
    outcome.times.finished = core::utcNow();
    removeOutputsIn(job.folder);
    if (const core::Status kept = writeOutcome(outcome, job.folder); !kept) {
        printMessage(kept.error().message.text());
    }
    return outcome;
}

}   // namespace angiopose::app
