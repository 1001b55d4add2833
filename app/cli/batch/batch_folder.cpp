#include "app/cli/batch/batch_folder.h"

#include "app/cli/batch/batch_job.h"
#include "app/cli/batch/batch_outcome.h"
#include "app/messages/messages.h"
#include "core/support/format_number.h"
#include "io/case/batch_manifest.h"
#include "io/support/atomic_file.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

namespace angiopose::app {
namespace {

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

/// Columns of reproducible results: header row, and row of one case (`outcome` is null if it is missing).
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

/// Columns of computing times, which differ between runs.
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

namespace fs = std::filesystem;

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

}   // namespace

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

}   // namespace angiopose::app
