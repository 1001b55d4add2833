#pragma once

#include "io/opening/loaded_inputs.h"
#include "io/support/read_observer.h"

namespace angiopose::io {

/// Reads vessels into `inputs` and traces a scan, segmentation or surface. If the user must answer a question first,
/// only records that question in `inputs` (`isScanUseUndecided`, `extentInUnknownUnits`).
core::Status addVessels(LoadedInputs& inputs, const std::string& path, const OpenHints& hints,
                        const std::string& seriesId, const ReadObserver& observe);

}   // namespace angiopose::io
