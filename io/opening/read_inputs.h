#pragma once

#include "io/opening/loaded_inputs.h"
#include "io/support/read_observer.h"

namespace angiopose::io {

/// Reads files together: either one case file, or at most one of each kind of input. Scans, segmentations and surfaces
/// are traced. Inputs of a case that have moved are searched for in the case's folder and in the places that the hints
/// give. Fails with one sentence.
core::Result<LoadedInputs> readInputs(const std::vector<std::string>& paths, const OpenHints& hints = {},
                                      const ReadObserver& observe = {});

}   // namespace angiopose::io
