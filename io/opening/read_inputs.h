#pragma once

#include "io/opening/loaded_inputs.h"
#include "io/support/read_observer.h"

namespace angiopose::io {

/// Reads several files together: either one case file, or at most one input of each kind. Traces scans, segmentations
/// and surfaces. Looks for moved inputs of a case in the case's folder and at the locations in the hints. The error is
/// always a single sentence.
core::Result<LoadedInputs> readInputs(const std::vector<std::string>& paths, const OpenHints& hints = {},
                                      const ReadObserver& observe = {});

}   // namespace angiopose::io
