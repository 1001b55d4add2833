#pragma once

#include "core/case/case.h"
#include "core/support/result.h"

#include <string>

namespace angiopose::io {

/// result.json of FORMATS §3 as text.
std::string resultJson(const core::Case& theCase, const core::RegistrationResult& result);

/// Writes it atomically.
core::Status writeResult(const core::Case& theCase, const core::RegistrationResult& result, const std::string& path);

}   // namespace angiopose::io