#pragma once

#include "core/support/message.h"

#include <string>
#include <string_view>
#include <vector>

namespace angiopose::io {

/// Adds digests to every stored result and tracking result in a case's JSON, for what the result depends on (FORMATS
/// §2.9): vessels, image, curves, geometry, initial pose, locks, method and options.
std::string withSealedResults(std::string_view caseJson);

/// Names of the parts that changed in the file since the result was saved. Empty if nothing changed, and for files
/// without digests.
struct ChangedParts {
    core::Messages besideResult;
    core::Messages besideFollowed;
};

/// The changed parts of each view: first the view stored in the case itself, then those of `views`.
std::vector<ChangedParts> changedBesideResults(std::string_view caseJson);

}   // namespace angiopose::io
