#pragma once

#include "core/case/case.h"
#include "core/support/result.h"
#include "io/case/case_settings.h"
#include "io/support/read_observer.h"

#include <string>

namespace angiopose::app {

/// Pair of input files: vessels (or a scan in which to trace them) and an angiogram.
struct InputPair {
    std::string vesselsPath;
    std::string angiogramPath;
};

/// Creates a case from both files, as the window does when they are opened together. Fails if a file contains several
/// series, or if the window would have to ask the user for the unit.
core::Result<core::Case> openPair(const InputPair& pair, const io::CaseSettings& settings, core::Messages& warnings,
                                  const io::ReadObserver& observe);

}   // namespace angiopose::app
