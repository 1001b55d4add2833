#pragma once

#include "io/case/load_case_with_options.h"

namespace angiopose::io {

/// Opens a case like openCase, with the options of `request`.
core::Result<core::Case> openCaseWithOptions(const CaseLoadOptions& request, const std::string& path,
                                             core::Messages& warnings, const ReadObserver& observe = {});

}   // namespace angiopose::io
