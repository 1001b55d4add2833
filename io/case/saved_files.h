#pragma once

#include "core/case/case.h"
#include "core/support/result.h"

#include <string>

namespace angiopose::io {

/// Completes what a case is about to say of its files, and of those of its other views: edited curves and
/// the bends of followed runs get files beside the case at `path`, hashes that are not known yet are noted. Views that
/// say nothing are left out; the shown one comes first.
core::Status completeFiles(core::Case& hashed, const std::string& path);

}   // namespace angiopose::io