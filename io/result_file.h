#pragma once

#include "core/case/case.h"
#include "core/support/result.h"
#include "core/workflow/register_case.h"

#include <string>

namespace angiopose::io {

/// What a registration began with, where that is known: only then it can be run again, or drawn, from its result
/// (opening/open_result.h).
struct ResultOrigin {
    const core::Case* asked = nullptr;
    std::string caseText;   ///< the same as askedCaseText (case/asked_case.h) tells it; empty: not told
};

/// result.json of FORMATS §3 as text.
std::string resultJson(const core::Case& theCase, const core::RegistrationResult& result,
                       const ResultOrigin& origin = {});

/// Writes it atomically.
core::Status writeResult(const core::Case& theCase, const core::RegistrationResult& result, const std::string& path);

/// What a registration found, as text: result.json of one view, joint.json of several (FORMATS §3).
std::string registeredJson(const core::RegisteredCase& registered, const ResultOrigin& origin);

/// Writes joint.json atomically: what holds for all views together, the result of each, and how far its geometry was
/// off. For several views only.
core::Status writeJointResult(const core::RegisteredCase& registered, const std::string& path,
                              const ResultOrigin& origin);

}   // namespace angiopose::io
