#pragma once

#include "core/case/case.h"
#include "core/support/result.h"

#include <string>

namespace angiopose::io {

/// Returns all measurements in the images and slices of a case as CSV (FORMATS §4). Each row contains a measurement
/// with its value at the case's poses, the scale, the source of the scale, and the limitations. If a value is missing,
/// its cell is empty and the notes column gives the reason.
std::string measurementTable(const core::Case& session);

core::Status writeMeasurements(const core::Case& session, const std::string& path);

}   // namespace angiopose::io
