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

/// What is looked for; what is empty is not asked about. `*` and `?` stand for any characters.
struct ArchiveQuery {
    ArchiveLevel level = ArchiveLevel::Study;
    std::string patientId;
    std::string patientName;   ///< UTF-8; its beginning, unless it holds `*` or `?`
    std::string dates;   ///< YYYYMMDD, or a range of two with '-' between; either may be missing
    std::string modality;   ///< CT, XA, …
    std::string accessionNumber;
    std::string studyUid;
};

/// A study or series that an archive holds. Texts are UTF-8; dates and times as DICOM writes them.
struct ArchiveMatch {
    std::string patientName, patientId, birthDate;
    std::string studyUid, studyDate, studyTime, studyDescription, accessionNumber;
    std::string modalities;   ///< of the study, "CT\XA"; of a series its own
    std::string seriesUid, seriesDescription, bodyPart;   ///< of a series
    int seriesNumber = 0;
    int objects = 0;   ///< 0: not told
};

struct ArchiveMatches {
    std::vector<ArchiveMatch> found;   ///< newest study first, series by number
    core::Messages warnings;
};

/// One object of a series.
struct ArchiveObject {
    std::string sopClass;   ///< empty: not told
    std::string sopInstance;
};

constexpr std::size_t maxMatches = 1000;
constexpr std::size_t maxSeriesStudies = 200;   ///< asked for their series one by one
constexpr std::size_t maxObjects = 50000;   ///< of one series, as of a folder

/// "2024-01-01..2024-02-01", "2024-01-01", "2024-01-01.." as `ArchiveQuery::dates`. Fails on anything else.
core::Result<std::string> queryDates(const std::string& text);

/// True for digits with single dots between, at most 64 characters: fit for a file name too.
bool isUid(const std::string& text);

/// The name as it is asked for.
std::string namePattern(const std::string& patientName);

/// In the order of `ArchiveMatches`, without those that the modality leaves out: some archives ignore it.
void settleMatches(const ArchiveQuery& query, std::vector<ArchiveMatch>& found);

/// How far an exchange with an archive is.
struct ArchiveProgress {
    std::size_t objects = 0;   ///< sent, come, or there already
    std::size_t all = 0;   ///< 0: not known
    std::uint64_t bytes = 0;
};

/// Called several times a second on the calling thread. Its Stop ends the exchange within about a second.
using ArchiveObserver = std::function<core::Verdict(const ArchiveProgress&)>;

/// What became of the objects of an exchange.
struct TransferReport {
    std::size_t all = 0;   ///< that were to be transferred; 0: not known
    std::size_t transferred = 0;
    std::size_t duplicates = 0;   ///< that were there already
    std::size_t failed = 0;
    std::uint64_t bytes = 0;   ///< of those transferred
    std::vector<std::string> folders;   ///< where what was retrieved lies, one per series
    core::Messages problems;   ///< of single objects, at most `maxProblems`
    std::optional<core::Error> end;   ///< why it ended early: an error or Stop

    static constexpr std::size_t maxProblems = 20;

    void note(const core::Message& problem)
    {
        if (problems.size() < maxProblems) {
            problems.push_back(problem);
        }
    }
    bool isWhole() const { return !end && failed == 0; }
};

/// "1.5 GB", for messages.
std::string sizeText(std::uint64_t bytes);

/// "0xA700".
std::string statusText(unsigned status);

}   // namespace angiopose::io
