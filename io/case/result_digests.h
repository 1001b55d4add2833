#pragma once

#include "core/support/message.h"

#include <string>
#include <string_view>
#include <vector>

namespace angiopose::io {

/// Adds to every result and tracking result in a case's JSON the digests of the data on which it depends (FORMATS
/// §2.9): vessels, image, curves, geometry, initial pose, locks, method and options.
std::string addResultDigests(std::string_view caseJson);

/// Names of the parts that changed in the file since a result was saved. Empty if nothing changed or the file has no
/// digests.
struct ChangedParts {
    core::Messages sinceResult;
    core::Messages sinceTracking;
};

/// Returns the changed parts of each view: first the view stored in the case itself, then those of `views`.
std::vector<ChangedParts> findChangesSinceResults(std::string_view caseJson);

}   // namespace angiopose::io
