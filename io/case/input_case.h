#pragma once

#include "core/case/case.h"
#include "core/workflow/register_case.h"

#include <string>

namespace angiopose::io {

/// Returns the input of a registration as the text of a case file, with which the registration can be repeated: poses,
/// geometry, tracing settings and options, with the file name (without folder) and content hash of each input. Contains
/// no results, notes or measurements. Empty if a file name cannot be encoded as JSON.
std::string inputCaseJson(const core::Case& asked);

/// Returns the input of a registration that has just finished.
std::string inputCaseJson(const core::RegisteredCase& registered);

/// Reduces a case to the shown view, which must have a result, and the views registered jointly with it.
core::Case keepJointlyRegisteredViews(core::Case session);

/// Returns the input of the registration that produced the results of a case from `keepJointlyRegisteredViews`, as far
/// as it is known. Empty if no initial pose is stored (older versions) or the registration changed the geometry.
std::string inputCaseJsonFromResult(core::Case jointViews);

}   // namespace angiopose::io
