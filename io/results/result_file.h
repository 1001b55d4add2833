#pragma once

#include "core/case/case.h"
#include "core/support/result.h"
#include "core/workflow/register_case.h"

#include <string>

namespace angiopose::io {

/// Specifies whether a result includes user-entered text, file names and UIDs.
enum class ResultTexts { Kept, LeftOut };

/// Returns the text of result.json (FORMATS §3). `inputCase` is the case at the start of the registration
/// (case/input_case.h), if known. Only a result that contains it can be used to repeat or display the registration
/// (opening/open_result.h).
std::string resultJson(const core::Case& session, const core::RegistrationResult& result,
                       const std::string& inputCase = {});

/// Returns the result of a registration that has just finished, for the view at index `place` of its case.
std::string resultJson(const core::RegisteredCase& registered, std::size_t viewPosition, ResultTexts names);

/// Returns the result of the shown view, with those inputs of its registration that the case still contains.
std::string storedResultJson(const core::Case& session, ResultTexts names);

/// Atomically writes the result of the shown view.
core::Status writeResult(const core::Case& session, const std::string& path);

/// Returns the outcome of a registration as JSON: result.json for one view, joint.json for several (FORMATS §3).
std::string registrationJson(const core::RegisteredCase& registered, const std::string& inputCase);

/// Atomically writes joint.json: the values shared by all views, and for each view its result and the estimated
/// geometry correction. Requires a registration of several views.
core::Status writeJointResult(const core::RegisteredCase& registered, const std::string& path,
                              const std::string& inputCase);

}   // namespace angiopose::io
