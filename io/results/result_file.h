#pragma once

#include "core/case/case.h"
#include "core/support/result.h"
#include "core/workflow/register_case.h"

#include <string>

namespace angiopose::io {

/// Whether a result includes text typed by users, file names and UIDs.
enum class ResultNames { Kept, LeftOut };

/// Returns result.json of FORMATS §3 as text. `askedCase`: the case at the start of the registration
/// (case/asked_case.h), if known; only then can the registration be repeated, or drawn, from its result
/// (opening/open_result.h).
std::string resultJson(const core::Case& session, const core::RegistrationResult& result,
                       const std::string& askedCase = {});

/// Returns the result of a registration just completed, for the view at `place` in its case.
std::string resultJson(const core::RegisteredCase& registered, std::size_t place, ResultNames names);

/// Returns the result of the shown view, with the inputs of its registration as far as the case still knows them.
std::string keptResultJson(const core::Case& session, ResultNames names);

/// Writes the result of the shown view atomically.
core::Status writeResult(const core::Case& session, const std::string& path);

/// Returns the outcome of a registration as text: result.json for one view, joint.json for several (FORMATS §3).
std::string registeredJson(const core::RegisteredCase& registered, const std::string& askedCase);

/// Writes joint.json atomically: the values shared by all views, the result of each, and the error found in its
/// geometry. For several views only.
core::Status writeJointResult(const core::RegisteredCase& registered, const std::string& path,
                              const std::string& askedCase);

}   // namespace angiopose::io
