#pragma once

#include "core/case/case.h"
#include "core/support/result.h"

#include <string>

namespace angiopose::io {

/// Completes the file references of a case and its other views before saving to `path`: writes files beside the case
/// for edited curves and tracked deformations and computes missing hashes. Drops blank views; the shown view comes
/// first.
core::Status completeFiles(core::Case& hashed, const std::string& path);

}   // namespace angiopose::io