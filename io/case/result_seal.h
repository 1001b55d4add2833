#pragma once

#include "core/support/message.h"

#include <string>
#include <string_view>
#include <vector>

namespace angiopose::io {

/// The case's JSON with, in every stored result, digests of what it stood beside when it was saved (FORMATS §2.9):
/// vessels, image, curves, geometry, start pose, locks, method and options.
std::string withSealedResults(std::string_view caseJson);

/// What of it has been changed in the file since, in words, for each view: first the one that stands in the case
/// itself, then those of `views`. Empty where all is as it was, and for results of files without digests.
std::vector<core::Messages> changedBesideResults(std::string_view caseJson);

}   // namespace angiopose::io
