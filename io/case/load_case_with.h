#pragma once

#include "io/case/case_file.h"
#include "io/case/case_settings.h"
#include "io/peak_frame.h"

namespace angiopose::io {

/// How a case is loaded that is not to be looked at.
struct CaseRequest {
    CaseSettings settings;   ///< over what the file says, tracing among them
    PeakFrame peak = PeakFrame::Sought;   ///< of runs whose frame the case says
    std::optional<std::string> text = std::nullopt;   ///< instead of what the file holds, which need be no case then
};

/// loadCase as wished.
core::Result<core::Case> loadCaseWith(const CaseRequest& request, const std::string& path, core::Messages& warnings,
                                      const ReadObserver& observe = {}, const MovedInputs& moved = {});

/// The files that a case file names, absolute, whether they are there or not; nothing of what is no case.
std::vector<std::string> filesNamedIn(const std::string& casePath);

/// Likewise of the text of a case that would lie at `casePath`, with the content that it knows of them.
std::vector<core::InputFile> filesNamedBy(const std::string& text, const std::string& casePath);

/// The files that a loaded case came from, with what they hashed to.
std::vector<core::InputFile> filesOf(const core::Case& session);

}   // namespace angiopose::io
