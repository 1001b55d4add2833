#pragma once

#include "angiopose/case.h"
#include "core/case/case.h"
#include "core/support/message.h"

#include <memory>
#include <string>

namespace angiopose {

struct Case::Content {
    core::Case values;
    core::Messages warnings;   ///< of reading
    std::string path;   ///< absolute, of the case file that was read or written last; empty: none
    std::string sha256;   ///< of what is known to lie there
};

namespace library {

/// Puts the run into a case that has vessels: its geometry, its suggested frame, and the start pose where that is
/// known.
void putAngiogram(core::Case& values, const std::shared_ptr<const core::Angiogram>& angiogram);

}   // namespace library
}   // namespace angiopose
