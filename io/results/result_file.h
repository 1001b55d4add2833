#pragma once

#include "core/case/case.h"
#include "core/support/result.h"
#include "core/workflow/register_case.h"

#include <string>

namespace angiopose::io {

/// Whether a result tells what people typed, names of files and UIDs.
enum class ResultNames { Kept, LeftOut };

/// result.json of FORMATS §3 as text. `askedCase`: what the registration began with (case/asked_case.h), where that is
/// known: only then it can be run again, or drawn, from its result (opening/open_result.h).
std::string resultJson(const core::Case& session, const core::RegistrationResult& result,
                       const std::string& askedCase = {});

/// Of a registration that was just made: that of the view at `place` in its case.
std::string resultJson(const core::RegisteredCase& registered, std::size_t place, ResultNames names);

/// Of the shown view's result, with what its registration began with as far as the case still knows it.
std::string keptResultJson(const core::Case& session, ResultNames names);

/// Writes it atomically.
core::Status writeResult(const core::Case& session, const std::string& path);

/// What a registration found, as text: result.json of one view, joint.json of several (FORMATS §3).
std::string registeredJson(const core::RegisteredCase& registered, const std::string& askedCase);

/// Writes joint.json atomically: what holds for all views together, the result of each, and how far its geometry was
/// off. For several views only.
core::Status writeJointResult(const core::RegisteredCase& registered, const std::string& path,
                              const std::string& askedCase);

}   // namespace angiopose::io
