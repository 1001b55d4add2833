#pragma once

#include "core/case/case.h"
#include "core/support/result.h"
#include "io/case/case_settings.h"
#include "io/support/read_observer.h"

#include <string>

namespace angiopose::app {

/// A file with vessels, or a scan in which they are traced, and one with an angiogram.
struct InputPair {
    std::string vesselsPath;
    std::string angiogramPath;
};

/// A case of both, as the window opens them together. Fails where a file holds several series, and where its unit
/// would have to be asked.
core::Result<core::Case> openTogether(const InputPair& pair, const io::CaseSettings& settings, core::Messages& warnings,
                                      const io::ReadObserver& observe);

}   // namespace angiopose::app
