#pragma once

#include "core/case/case.h"
#include "core/support/result.h"

#include <string>

namespace angiopose::io {

/// Everything that was measured in the images and slices of a case as a comma-separated table (FORMATS §4): a row each,
/// with the value at the case's poses, the scale it was found with, where that comes from and what speaks against it.
/// Where there is no value the cell is empty and the notes say why.
std::string measurementTable(const core::Case& session);

core::Status writeMeasurements(const core::Case& session, const std::string& path);

}   // namespace angiopose::io
