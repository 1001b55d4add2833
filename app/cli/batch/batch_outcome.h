#pragma once

#include "core/support/message.h"
#include "core/workflow/register_case.h"
#include "io/case/input_fingerprint.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace angiopose::app {

/// Computing times of one case; they differ between runs.
struct BatchTimes {
    double readMs = 0.0;   ///< includes the time for vessel tracing
    double traceMs = 0.0;   ///< time for the shown frame
    double registerMs = 0.0;
    double writeMs = 0.0;
    std::string finished;   ///< time of completion, ISO 8601, UTC
};

/// An output file of a case, with its path relative to the folder of the case.
struct WrittenFile {
    std::string path;
    std::uint64_t size = 0;
};

/// Outcome of one case of a batch: its table row and the data that identify it. Stored as outcome.json in the folder of
/// the case after all other files are written.
struct BatchOutcome {
    std::string name;
    std::string status;   ///< "done", "not trustworthy", "failed", "crashed", "out of time"
    std::string method;
    std::size_t viewCount = 0;
    std::vector<double> figures;   ///< in the order of figureNames(); empty if the case has no result
    std::string message;   ///< warnings of the result, or the reason why there is no result
    std::vector<std::string> notes;   ///< warnings from opening the case
    std::string request;   ///< see serializeRequest
    std::vector<io::InputFingerprint> inputs;
    std::vector<WrittenFile> files;
    BatchTimes times;

    bool hasResult() const { return !figures.empty(); }
};

/// Returns the names of the table columns that hold the figures of a result.
const std::vector<std::string_view>& figureNames();

/// Copies the results of a registration into the outcome.
void addResult(BatchOutcome& outcome, const core::RegisteredCase& registered);

/// Convert an outcome to one line of JSON and back; parsing throws std::exception if the text is not an outcome.
std::string toJsonLine(const BatchOutcome& outcome);
BatchOutcome parseOutcome(const std::string& json);

/// Stores the outcome in the folder of its case, creating the folder if needed.
core::Status writeOutcome(const BatchOutcome& outcome, const std::string& folder);
/// Reads a stored outcome; nullopt if it is missing or incomplete.
std::optional<BatchOutcome> readOutcome(const std::string& folder);

/// Returns whether a new run would give the same outcome: same request, same inputs and all files present. Outcomes
/// that are crashes or timeouts are never up to date, since a retry may succeed.
bool isUpToDate(const BatchOutcome& outcome, const std::string& request, const std::string& folder);

}   // namespace angiopose::app
