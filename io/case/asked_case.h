#pragma once

#include "io/result_file.h"

#include <string>

namespace angiopose::io {

/// A case as a registration began with it, as the text of a case file for others to begin with it again: poses and
/// geometry, how all is traced, options; each input by the name of its file, not its folder, and its content. Without
/// findings, notes and measurements. Empty where a file name cannot be told in JSON.
std::string askedCaseText(const core::Case& asked);

/// Of a registration, for its result.
ResultOrigin originOf(const core::RegisteredCase& registered);

}   // namespace angiopose::io
