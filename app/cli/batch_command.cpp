#include "app/cli/batch_summary.h"
#include "app/cli/case_input.h"
#include "app/cli/commands.h"
#include "app/cli/register_case.h"
#include "app/cli/register_outputs.h"
#include "app/cli/shard.h"
#include "app/messages/says.h"
#include "core/support/stopwatch.h"
#include "io/support/atomic_file.h"

#include <cstdio>
#include <exception>
#include <filesystem>

namespace angiopose::app {
namespace {

namespace fs = std::filesystem;

core::Result<core::RegistrationResult> registerEntry(const io::BatchEntry& entry, const std::string& folder)
{
    core::Stopwatch watch;
    auto loaded = loadCaseForCommand(entry.casePath, entry.frame);
    if (!loaded) {
        return loaded.error();
    }
    const double readMs = watch.lapMs();
    core::Case theCase = std::move(loaded).value();
    RegisterArguments arguments;
    arguments.method = entry.method;
    if (const auto status = applyArguments(theCase, arguments); !status) {
        return status.error();
    }
    const auto registered = registerForCommand(std::move(theCase), entry.name, {.readMs = readMs});
    if (!registered) {
        return registered.error();
    }
    if (const auto status = writeOutputs(registered.value(), folder); !status) {
        return status.error();
    }
    return registered.value().result();
}

/// Whatever goes wrong with one case stays with it.
BatchOutcome outcomeOf(const io::BatchEntry& entry, const std::string& folder)
{
    BatchOutcome outcome{entry, std::nullopt, std::nullopt};
    try {
        auto result = registerEntry(entry, folder);
        if (result) {
            outcome.result = std::move(result).value();
        } else {
            outcome.problem = result.error();
        }
    } catch (const std::bad_alloc&) {
        outcome.problem = says::notEnoughMemory();
    } catch (const std::exception& error) {
        outcome.problem = says::unexpectedFailure(error.what());
    }
    return outcome;
}

core::Status makeFolder(const std::string& folder)
{
    std::error_code failure;
    fs::create_directories(folder, failure);
    return failure ? core::Status(core::Error(says::folderNotMade(folder, failure.message())))
                   : core::Status(core::Done{});
}

void printOutcome(const BatchOutcome& outcome)
{
    std::printf("%-16s %s\n", outcome.status().c_str(), outcome.entry.name.c_str());
    std::fflush(stdout);
    if (!outcome.result) {
        printMessage(outcome.entry.name + ": " + outcome.problem->message.text());
    }
}

/// One table a shard, so that shards that share a folder do not write over each other's rows.
std::string summaryName(const core::Shard& shard)
{
    return shard.count == 1
               ? "summary.csv"
               : "summary-" + std::to_string(shard.index + 1) + "-of-" + std::to_string(shard.count) + ".csv";
}

/// Worst of all cases: stopped, failed, not trustworthy, done.
int worseOf(int exitCode, const BatchOutcome& outcome)
{
    const std::string status = outcome.status();
    if (exitCode == exitStopped || status == "stopped") {
        return exitStopped;
    }
    if (exitCode == exitInput || status == "failed") {
        return exitInput;
    }
    return status == "done" ? exitCode : exitNotTrustworthy;
}

}   // namespace

int runBatch(const BatchArguments& arguments)
{
    const auto shard = shardFrom(arguments.shard);
    if (!shard) {
        printMessage(shard.error().message.text());
        return exitUsage;
    }
    const auto entries = io::readManifest(arguments.manifestPath);
    if (!entries) {
        return failInput(entries.error());
    }
    if (const auto status = makeFolder(arguments.outputFolder); !status) {
        return failInput(status.error());
    }
    const fs::path output(arguments.outputFolder);
    const std::string summaryPath = (output / summaryName(shard.value())).string();
    std::string summary = summaryHeader();
    int exitCode = exitDone;
    for (std::size_t k = shard.value().index; k < entries.value().size(); k += shard.value().count) {
        const io::BatchEntry& entry = entries.value()[k];
        const BatchOutcome outcome = outcomeOf(entry, (output / entry.name).string());
        printOutcome(outcome);
        summary += summaryRow(outcome);
        exitCode = worseOf(exitCode, outcome);
        // After each case, so that a power cut costs one of them.
        if (const auto status = io::writeAtomically(summaryPath, summary); !status) {
            return failInput(status.error());
        }
        if (isInterrupted()) {
            return exitStopped;
        }
    }
    return exitCode;
}

}   // namespace angiopose::app