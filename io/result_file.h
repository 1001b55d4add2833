#pragma once

#include "core/case/case.h"
#include "core/support/result.h"
#include "core/workflow/register_case.h"

#include <string>

namespace angiopose::io {

/// result.json of FORMATS §3 as text.
std::string resultJson(const core::Case& theCase, const core::RegistrationResult& result);

/// Writes it atomically.
core::Status writeResult(const core::Case& theCase, const core::RegistrationResult& result, const std::string& path);

/// What a registration found, as text: result.json of one view, joint.json of several (FORMATS §3).
std::string registeredJson(const core::RegisteredCase& registered);

/// Writes joint.json atomically: what holds for all views together, the result of each, and how far its geometry was
/// off. For several views only.
core::Status writeJointResult(const core::RegisteredCase& registered, const std::string& path);

}   // namespace angiopose::io
