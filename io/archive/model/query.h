#pragma once

#include "core/support/result.h"
#include "core/support/verdict.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace angiopose::io {

enum class ArchiveLevel { Study, Series };

/// Search criteria; empty ones are ignored. `*` and `?` are wildcards.
struct ArchiveQuery {
    ArchiveLevel level = ArchiveLevel::Study;
    std::string patientId;
    std::string patientName;   ///< UTF-8; matches the beginning of the name unless it contains `*` or `?`
    std::string dates;   ///< YYYYMMDD, or a range of two joined by '-'; either end may be missing
    std::string modality;   ///< CT, XA, …
    std::string accessionNumber;
    std::string studyUid;
};

/// A study or series in an archive. Texts are UTF-8; dates and times are in DICOM format.
struct ArchiveMatch {
    std::string patientName, patientId, birthDate;
    std::string studyUid, studyDate, studyTime, studyDescription, accessionNumber;
    std::string modalities;   ///< all of a study, for example "CT\XA"; the single one of a series
    std::string seriesUid, seriesDescription, bodyPart;   ///< empty for a study
    int seriesNumber = 0;
    int objects = 0;   ///< 0: not reported
};

struct ArchiveMatches {
    std::vector<ArchiveMatch> found;   ///< newest study first, series by number
    core::Messages warnings;
};

/// One object of a series.
struct ArchiveObject {
    std::string sopClass;   ///< empty: not reported
    std::string sopInstance;
};

constexpr std::size_t maxMatches = 1000;
constexpr std::size_t maxSeriesStudies = 200;   ///< maximum number of studies whose series are queried one by one
constexpr std::size_t maxObjects = 50000;   ///< maximum per series, as per folder

/// Converts "2024-01-01..2024-02-01", "2024-01-01" or "2024-01-01.." to `ArchiveQuery::dates`. Fails on anything else.
core::Result<std::string> queryDates(const std::string& text);

/// True for digits separated by single dots, at most 64 characters; such a text is also safe as a file name.
bool isUid(const std::string& text);

/// Returns the patient name as a query pattern.
std::string namePattern(const std::string& patientName);

/// Sorts matches as `ArchiveMatches` specifies and removes those of other modalities, which some archives return
/// anyway.
void settleMatches(const ArchiveQuery& query, std::vector<ArchiveMatch>& found);

/// Progress of a transfer to or from an archive.
struct ArchiveProgress {
    std::size_t objects = 0;   ///< sent, received or already present
    std::size_t all = 0;   ///< total; 0: unknown
    std::uint64_t bytes = 0;
};

/// Called several times a second on the calling thread. Returning Stop ends the transfer within about a second.
using ArchiveObserver = std::function<core::Verdict(const ArchiveProgress&)>;

/// The outcome of a transfer.
struct TransferReport {
    std::size_t all = 0;   ///< objects to transfer; 0: unknown
    std::size_t transferred = 0;
    std::size_t duplicates = 0;   ///< objects already present
    std::size_t failed = 0;
    std::uint64_t bytes = 0;   ///< bytes transferred
    std::vector<std::string> folders;   ///< folders of the retrieved series, one per series
    core::Messages problems;   ///< problems of single objects, at most `maxProblems`
    std::optional<core::Error> end;   ///< the reason for an early end: an error or Stop

    static constexpr std::size_t maxProblems = 20;

    void note(const core::Message& problem)
    {
        if (problems.size() < maxProblems) {
            problems.push_back(problem);
        }
    }
    bool isWhole() const { return !end && failed == 0; }
};

/// Formats a size for messages, for example "1.5 GB".
std::string sizeText(std::uint64_t bytes);

/// Formats a status code, for example "0xA700".
std::string statusText(unsigned status);

}   // namespace angiopose::io
