#pragma once

#include "core/support/result.h"
#include "io/case/case_document.h"
#include "io/peak_frame.h"
#include "io/support/read_observer.h"

#include <string>
#include <vector>

namespace angiopose::io {

/// All files that the case refers to: vessels, scan, image, target, and the other views with their files.
std::vector<core::InputFile*> inputsOf(CaseDocument& document);

/// Resolves the paths of a case file relative to its folder.
void makePathsAbsolute(CaseDocument& document, const std::string& casePath);

/// Reads the inputs of a case (absolute paths) and checks them against its content: frame, camera size, branches,
/// hashes, initial pose. Does not read other views. Need not search for the peak-opacification frame if the case gives
/// the frame.
core::Result<core::Case> loadInputs(CaseDocument document, const std::string& casePath, core::Messages& warnings,
                                    const ReadObserver& observe, PeakFrame peak = PeakFrame::Sought);

}   // namespace angiopose::io