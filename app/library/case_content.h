#pragma once

#include "angiopose/case.h"
#include "core/case/case.h"
#include "core/support/message.h"

#include <memory>
#include <string>

namespace angiopose {

struct Case::Content {
    core::Case values;
    core::Messages warnings;   ///< warnings from reading the case
    std::string path;   ///< absolute path of the case file that was last read or written; empty if there is none
    std::string sha256;   ///< last known hash of the file at `path`
};

namespace library {

/// Adds an angiogram to a case that has vessels, with its geometry and suggested frame and, if known, the initial pose.
void addAngiogram(core::Case& values, const std::shared_ptr<const core::Angiogram>& angiogram);

}   // namespace library
}   // namespace angiopose
