#pragma once

#include "core/support/observer_decision.h"
#include "core/support/result.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace angiopose::io {

enum class ArchiveLevel { Study, Series };

/// Search criteria; empty criteria are ignored. `*` and `?` are wildcards.
struct ArchiveQuery {
    ArchiveLevel level = ArchiveLevel::Study;
    std::string patientId;
    std::string patientName;   ///< patient name, UTF-8; matched as a prefix unless it contains `*` or `?`
    std::string dates;   ///< study date, YYYYMMDD, or two dates joined by '-', either of which may be omitted
    std::string modality;   ///< CT, XA, …
    std::string accessionNumber;
    std::string studyUid;
};

/// Study or series in an archive. Strings are UTF-8; dates and times are in DICOM format.
struct ArchiveMatch {
    std::string patientName, patientId, birthDate;
    std::string studyUid, studyDate, studyTime, studyDescription, accessionNumber;
    std::string modalities;   ///< for a study, all modalities ("CT\XA"); for a series, its modality
    std::string seriesUid, seriesDescription, bodyPart;   ///< empty for a study
    int seriesNumber = 0;
    int objects = 0;   ///< number of objects; 0 if the archive does not report it
};

struct ArchiveMatches {
    std::vector<ArchiveMatch> found;   ///< studies from newest to oldest, or the series of a study by number
    core::Messages warnings;
};

/// One object of a series in an archive.
struct ArchiveObject {
    std::string sopClass;   ///< empty if not reported
    std::string sopInstance;
};

constexpr std::size_t maxMatches = 1000;
constexpr std::size_t maxSeriesStudies = 200;   ///< maximum number of studies whose series are queried study by study
constexpr std::size_t maxObjects = 50000;   ///< maximum number of objects per series, the same as per folder

/// Converts "2024-01-01..2024-02-01", "2024-01-01" or "2024-01-01.." to `ArchiveQuery::dates`. Fails on anything else.
core::Result<std::string> parseQueryDates(const std::string& text);

/// Returns whether the text is digits separated by single dots, at most 64 characters, and so also safe as a file name.
bool isUid(const std::string& text);

/// Returns the patient name as a query pattern.
std::string namePattern(const std::string& patientName);

/// Sorts matches as `ArchiveMatches` specifies and removes those of other modalities, because some archives ignore that
/// criterion.
void sortAndFilterMatches(const ArchiveQuery& query, std::vector<ArchiveMatch>& found);

/// Progress of a transfer to or from an archive.
struct ArchiveProgress {
    std::size_t objects = 0;   ///< number of objects sent, received or already present
    std::size_t all = 0;   ///< total number of objects; 0 if unknown
    std::uint64_t bytes = 0;
};

/// Called several times per second on the calling thread. Returning Stop cancels the transfer within about a second.
using ArchiveObserver = std::function<core::ObserverDecision(const ArchiveProgress&)>;

/// The outcome of a transfer.
struct TransferReport {
    std::size_t all = 0;   ///< number of objects to transfer; 0 if unknown
    std::size_t transferred = 0;
    std::size_t duplicates = 0;   ///< objects already present
    std::size_t failed = 0;
    std::uint64_t bytes = 0;   ///< bytes transferred
    std::vector<std::string> folders;   ///< folders of the retrieved series, one per series
    core::Messages problems;   ///< problems with individual objects, at most `maxProblems`
    std::optional<core::Error> end;   ///< reason why the transfer ended early: an error or cancellation

    static constexpr std::size_t maxProblems = 20;

    void addProblem(const core::Message& problem)
    {
        if (problems.size() < maxProblems) {
            problems.push_back(problem);
        }
    }
    bool isComplete() const { return !end && failed == 0; }
};

/// Formats a size for messages, for example "1.5 GB".
std::string sizeText(std::uint64_t bytes);

/// Formats a status code, for example "0xA700".
std::string statusText(unsigned status);

}   // namespace angiopose::io
