#pragma once

#include "core/case/case.h"
#include "core/support/result.h"

#include <string>

namespace angiopose::io {

/// Completes the file references of a case and its other views before saving to `path`: writes edited curves and
/// tracked deformations to files next to the case and computes missing hashes. Removes blank views and puts the shown
/// view first.
core::Status writeCompanionFiles(core::Case& savedCase, const std::string& path);

}   // namespace angiopose::io
