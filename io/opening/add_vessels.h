#pragma once

#include "io/opening/loaded_inputs.h"
#include "io/support/read_observer.h"

namespace angiopose::io {

/// Reads vessels into `inputs`, tracing a scan, segmentation or surface, or records there which question the user has
/// to answer first (`isScanAsked`, `askedUnitsAcross`).
core::Status addVessels(LoadedInputs& inputs, const std::string& path, const OpenHints& hints,
                        const std::string& seriesId, const ReadObserver& observe);

}   // namespace angiopose::io
