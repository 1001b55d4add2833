#pragma once

#include "angiopose/case.h"
#include "core/registration_case.h"
#include "core/support/message.h"

#include <memory>

namespace angiopose {

struct Case::Content {
    core::RegistrationCase values;
    core::Messages warnings;   ///< of reading
};

namespace library {

/// Puts the run into a case that has vessels: its geometry, its suggested frame, and the start pose where that is
/// known.
void putAngiogram(core::RegistrationCase& values, const std::shared_ptr<const core::Angiogram>& angiogram);

}   // namespace library
}   // namespace angiopose
