#pragma once

#include "io/case/case_file.h"
#include "io/case/case_settings.h"
#include "io/peak_frame.h"

namespace angiopose::io {

/// Options for loading a case outside the GUI.
struct CaseLoadOptions {
    CaseSettings settings;   ///< settings that override the values in the file, including tracing settings
    PeakFrameSearch peak = PeakFrameSearch::Enabled;   ///< applies to cine runs for which the case specifies the frame
    std::optional<std::string> text =
        std::nullopt;   ///< if set, used instead of the contents of the file, which then need not be a case
};

/// Loads a case like loadCase, with the options of `request`.
core::Result<core::Case> loadCaseWithOptions(const CaseLoadOptions& request, const std::string& path,
                                             core::Messages& warnings, const ReadObserver& observe = {},
                                             const MovedInputs& moved = {});

/// Returns the absolute paths of all files named in a case file, whether they exist or not; empty if it is not a case.
std::vector<std::string> referencedPaths(const std::string& casePath);

/// Returns the files that the text of a case at `casePath` names, with their stored content hashes.
std::vector<core::InputFile> referencedFiles(const std::string& text, const std::string& casePath);

/// Returns the files from which a loaded case was read, with their content hashes.
std::vector<core::InputFile> inputFilesOf(const core::Case& session);

}   // namespace angiopose::io
