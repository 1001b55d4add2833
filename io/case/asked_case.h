#pragma once

#include "core/case/case.h"
#include "core/workflow/register_case.h"

#include <string>

namespace angiopose::io {

/// A case as a registration began with it, as the text of a case file for others to begin with it again: poses and
/// geometry, how all is traced, options; each input by the name of its file, not its folder, and its content. Without
/// findings, notes and measurements. Empty where a file name cannot be told in JSON.
std::string askedCaseText(const core::Case& asked);

/// What a registration that was just made began with.
std::string askedCaseText(const core::RegisteredCase& registered);

/// A case with the views alone that were registered together with the shown one, which has a result.
core::Case viewsOfItsRun(core::Case session);

/// What the run that found the results of such a case began with, as far as it is still known: empty where no start
/// pose was noted (by an earlier version), or where the run changed the geometry.
std::string askedCaseTextOfRun(core::Case ofOneRun);

}   // namespace angiopose::io
