#pragma once

#include "core/support/result.h"
#include "io/case/case_document.h"
#include "io/peak_frame.h"
#include "io/support/read_observer.h"

#include <string>
#include <vector>

namespace angiopose::io {

/// Returns all files to which the case refers: vessels, scan, image, target, and the other views with their files.
std::vector<core::InputFile*> inputsOf(CaseDocument& document);

/// Makes the paths of a case file absolute; relative paths are relative to the folder of the case file.
void makePathsAbsolute(CaseDocument& document, const std::string& casePath);

/// Reads the inputs of a case (absolute paths) and checks them against the values of the case: frame, camera size,
/// branches, hashes, initial pose. Does not read other views. `peak` may skip the search for the peak-opacification
/// frame if the case specifies the frame.
core::Result<core::Case> loadInputs(CaseDocument document, const std::string& casePath, core::Messages& warnings,
                                    const ReadObserver& observe, PeakFrameSearch peak = PeakFrameSearch::Enabled);

}   // namespace angiopose::io
