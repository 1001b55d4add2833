#pragma once

#include "core/support/message.h"

#include <string>
#include <string_view>
#include <vector>

namespace angiopose::io {

/// The case's JSON with, in every stored result and in what following found, digests of what it stood beside when it
/// was saved (FORMATS §2.9): vessels, image, curves, geometry, start pose, locks, method and options.
std::string withSealedResults(std::string_view caseJson);

/// What has been changed in the file since, in words. Empty where all is as it was, and for files without digests.
struct ChangedParts {
    core::Messages besideResult;
    core::Messages besideFollowed;
};

/// Of each view: first the one that stands in the case itself, then those of `views`.
std::vector<ChangedParts> changedBesideResults(std::string_view caseJson);

}   // namespace angiopose::io
