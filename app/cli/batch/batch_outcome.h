#pragma once

#include "core/support/message.h"
#include "core/workflow/register_case.h"
#include "io/case/input_facts.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace angiopose::app {

/// What a case took; nothing in it is the same in the next run.
struct BatchTimes {
    double readMs = 0.0;   ///< tracing of vessels among it
    double traceMs = 0.0;   ///< of the shown frame
    double registerMs = 0.0;
    double writeMs = 0.0;
    std::string finished;   ///< ISO 8601, UTC
};

/// A file of an outcome, by its path in the folder of the case.
struct WrittenFile {
    std::string path;
    std::uint64_t size = 0;
};

/// How one case of a batch ended: the row of the table, and by what it is known again. Kept as outcome.json in the
/// folder of the case, written when all else of it is there.
struct BatchOutcome {
    std::string name;
    std::string status;   ///< "done", "not trustworthy", "failed", "crashed", "out of time"
    std::string method;
    std::size_t viewCount = 0;
    std::vector<double> figures;   ///< as figureNames(); none where the case has no result
    std::string message;   ///< warnings of the result, or why there is none
    std::vector<std::string> notes;   ///< warnings of opening the case
    std::string asked;   ///< see askedOf
    std::vector<io::InputFacts> inputs;
    std::vector<WrittenFile> files;
    BatchTimes times;

    bool hasResult() const { return !figures.empty(); }
};

/// Columns of the table that are figures of a result.
const std::vector<std::string_view>& figureNames();

/// Fills in what a registration found.
void addResult(BatchOutcome& outcome, const core::RegisteredCase& registered);

/// One line of JSON; and back, throws std::exception where it is none.
std::string lineOf(const BatchOutcome& outcome);
BatchOutcome outcomeFrom(const std::string& json);

/// Keeps it in the folder of its case, which is made where it is not there.
core::Status writeOutcome(const BatchOutcome& outcome, const std::string& folder);
/// Nothing where there is none, or none that is whole.
std::optional<BatchOutcome> readOutcome(const std::string& folder);

/// Whether it is what a new run would find: asked alike, of the same inputs, with all its files. One that crashed or
/// ran out of time is not: on another day it may end well.
bool isUpToDate(const BatchOutcome& outcome, const std::string& asked, const std::string& folder);

}   // namespace angiopose::app
