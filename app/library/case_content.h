#pragma once

#include "angiopose/case.h"
#include "core/case/case.h"
#include "core/support/message.h"

#include <memory>

namespace angiopose {

struct Case::Content {
    core::Case values;
    core::Messages warnings;   ///< of reading
};

namespace library {

/// Puts the run into a case that has vessels: its geometry, its suggested frame, and the start pose where that is
/// known.
void putAngiogram(core::Case& values, const std::shared_ptr<const core::Angiogram>& angiogram);

}   // namespace library
}   // namespace angiopose
