#pragma once

#include "core/case/case.h"
#include "core/support/result.h"
#include "io/case/case_settings.h"
#include "io/support/read_observer.h"

#include <string>

namespace angiopose::app {

/// File with vessels, or a scan in which to trace them, and file with an angiogram.
struct InputPair {
    std::string vesselsPath;
    std::string angiogramPath;
};

/// Creates a case from both, as opening them together in the window does. Fails if a file holds several series, or if
/// its unit would have to be asked for.
core::Result<core::Case> openTogether(const InputPair& pair, const io::CaseSettings& settings, core::Messages& warnings,
                                      const io::ReadObserver& observe);

}   // namespace angiopose::app
