#pragma once

#include "core/registration_case.h"
#include "core/support/result.h"

#include <string>

namespace angiopose::io {

/// Completes what a case is about to say of its files, and of those of its other views: edited curves get a file beside
/// the case at `path`, hashes that are not known yet are noted. Views that say nothing are left out.
core::Status completeFiles(core::RegistrationCase& hashed, const std::string& path);

}   // namespace angiopose::io