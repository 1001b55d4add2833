#pragma once

#include "angiopose/case.h"
#include "core/case/case.h"
#include "core/support/message.h"

#include <memory>
#include <string>

namespace angiopose {

struct Case::Content {
    core::Case values;
    core::Messages warnings;   ///< from reading the case
    std::string path;   ///< absolute path of the case file read or written last; empty: none
    std::string sha256;   ///< hash of the file last known to be at `path`
};

namespace library {

/// Adds an angiogram to a case that has vessels: its geometry, its suggested frame and, if known, the initial pose.
void putAngiogram(core::Case& values, const std::shared_ptr<const core::Angiogram>& angiogram);

}   // namespace library
}   // namespace angiopose
