#pragma once

#include "core/case/case.h"

namespace angiopose::io {

/// Lets go of results whose inputs are not those any more that they were found with. `noted`: the case as its file has
/// it, `read`: with the files as they are. Adds a warning for each file such a result stood in.
void dropStaleResults(const core::Case& noted, core::Case& read, core::Messages& warnings);

}   // namespace angiopose::io
