#pragma once

#include "core/support/result.h"
#include "io/case/case_document.h"
#include "io/peak_frame.h"
#include "io/support/read_observer.h"

#include <string>
#include <vector>

namespace angiopose::io {

/// Every file that the case refers to: vessels, scan, image, target, other views and theirs.
std::vector<core::InputFile*> inputsOf(CaseDocument& document);

/// Paths of a case file are relative to its folder.
void makePathsAbsolute(CaseDocument& document, const std::string& casePath);

/// The case with its inputs (absolute paths) read and checked against what it says: frame, camera size, branches,
/// hashes, start pose. Other views are not read. Of
/// a run whose frame it says the fullest one need not be sought.
core::Result<core::Case> loadInputs(CaseDocument document, const std::string& casePath, core::Messages& warnings,
                                    const ReadObserver& observe, PeakFrame peak = PeakFrame::Sought);

}   // namespace angiopose::io