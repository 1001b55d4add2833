#include "app/cli/batch/batch_row.h"

#include "app/cli/case_input.h"
#include "app/cli/console.h"
#include "app/cli/register_case.h"
#include "app/cli/register_outputs.h"
#include "app/messages/says.h"
#include "app/messages/says_batch.h"
#include "core/support/stopwatch.h"
#include "core/support/utc_time.h"
#include "io/case/load_case_with.h"
#include "io/opening/assemble_case.h"
#include "io/opening/open_case_with.h"
#include "io/opening/read_inputs.h"
#include "io/support/system/held_file.h"
#include "io/vessel_input_file.h"

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

/// How the vessels of the row are read; nothing where that follows from the file alone.
core::Result<std::optional<core::VesselInput>> vesselInputOf(const BatchJob& job, const io::CaseSettings& settings)
{
    core::Case asked;
    settings.applyTo(asked);
    if (asked.vessels.input == core::VesselInput()) {
        return std::optional<core::VesselInput>();
    }
    const auto kind = io::vesselInputKindOf(job.vesselsPath);
    if (!kind) {
        return kind.error();
    }
    asked.vessels.input.kind = kind.value();
    return std::optional(asked.vessels.input);
}

/// A case of a file with vessels and one with an angiogram, as the window opens them together.
core::Result<core::Case> openTogether(const BatchJob& job, const io::CaseSettings& settings, core::Messages& warnings)
{
    io::OpenHints hints;
    auto vessels = vesselInputOf(job, settings);
    if (!vessels) {
        return vessels.error();
    }
    hints.vessels = std::move(vessels).value();
    auto read = io::readInputs({job.vesselsPath, job.angiogramPath}, hints, goOnUnlessStopped);
    if (!read) {
        return read.error();
    }
    const io::LoadedInputs inputs = std::move(read).value();
    if (!inputs.offered.empty()) {
        return core::Error(says::batchSeveralSeries(inputs.offered.size()).about(job.vesselsPath));
    }
    if (inputs.askedUnitsAcross) {
        return core::Error(says::batchUnitUnclear(core::Quantity{*inputs.askedUnitsAcross, 1}).about(job.vesselsPath));
    }
    warnings.insert(warnings.end(), inputs.warnings.begin(), inputs.warnings.end());
    core::Case theCase = io::withInputs(core::Case(), inputs);
    settings.applyTo(theCase);
    return theCase;
}

core::Result<core::Case> openRow(const BatchJob& job, core::Messages& warnings)
{
    io::CaseSettings settings;
    if (const auto status = settings.add(job.settings); !status) {
        return status.error();
    }
    auto opened = job.casePath.empty() ? openTogether(job, settings, warnings)
                                       : io::openCaseWith({settings, io::FullestFrame::NotNeeded}, job.casePath,
                                                          warnings, goOnUnlessStopped);
    if (!opened) {
        return opened.error();
    }
    auto moved = atFrame(std::move(opened).value(), job.frame, job.casePath.empty() ? job.angiogramPath : job.casePath);
    if (!moved) {
        return moved.error();
    }
    core::Case theCase = std::move(moved).value();
    RegisterArguments arguments;
    arguments.method = job.method;
    if (const auto status = applyArguments(theCase, arguments); !status) {
        return status.error();
    }
    return theCase;
}

/// The files that it came from: of one that could not be opened those that are named.
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

core::Status registerOpened(BatchOutcome& outcome, const BatchJob& job, core::Case theCase)
{
    auto registered = registerQuietly(std::move(theCase), {.readMs = outcome.times.readMs});
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

/// An outcome without its findings.
BatchOutcome begunOutcome(const BatchJob& job)
{
    BatchOutcome outcome;
    outcome.name = job.name;
    outcome.method = job.method;
    outcome.asked = job.asked;
    return outcome;
}

/// Two programs never write into one folder at once; the second then finds what the first has done.
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
        fail(outcome, says::folderNotMade(job.folder, failure.message()));
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
        fail(outcome, says::notEnoughMemory());
    } catch (const std::exception& error) {
        fail(outcome, says::unexpectedFailure(error.what()));
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
