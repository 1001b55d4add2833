#pragma once

#include "io/case/load_case_with.h"

namespace angiopose::io {

/// openCase as wished.
core::Result<core::Case> openCaseWith(const CaseRequest& request, const std::string& path, core::Messages& warnings,
                                      const ReadObserver& observe = {});

}   // namespace angiopose::io
