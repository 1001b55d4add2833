#pragma once

#include "core/support/result.h"
#include "io/case/batch_manifest.h"
#include "io/case/case_settings.h"

#include <optional>
#include <string>
#include <vector>

namespace angiopose::app {

/// A batch row as sent to a worker.
struct BatchJob {
    std::string name;
    std::string casePath;   ///< if empty, the two inputs below are used
    std::string vesselsPath;
    std::string angiogramPath;
    std::string method;   ///< if empty, the method of the case
    std::optional<int> frame;   ///< if not set, the frame of the case
    std::vector<std::string> settings;   ///< "name=value" pairs; see io::CaseSettings
    std::string folder;   ///< output folder used by this row only
    std::string request;   ///< everything that determines the outcome, except the inputs, as JSON; see serializeRequest
    bool resumes = false;   ///< whether to keep an existing outcome that is up to date
    bool skipImages = false;
};

/// Serializes the request of a row without file paths, so that the text does not depend on where the manifest is
/// stored. `common` applies to all rows.
std::string serializeRequest(const io::BatchEntry& entry, const io::CaseSettings& common);

/// Returns whether two requests describe the same row, regardless of common settings.
bool isSameRow(const std::string& request, const std::string& other);
/// Returns whether two requests have the same common settings and program version.
bool haveSameSettings(const std::string& request, const std::string& other);

BatchJob makeJob(const io::BatchEntry& entry, const io::CaseSettings& common, const std::string& outputFolder);

/// Serializes a job to one line.
std::string toJsonLine(const BatchJob& job);
/// Parses a job; throws std::exception if the line is not a job.
BatchJob parseJob(const std::string& line);

}   // namespace angiopose::app
