#pragma once

#include "core/support/result.h"

#include <string>

namespace angiopose::io {

/// Puts the files of a folder and of those below it into a ZIP archive, atomically, under their paths in it, in the
/// order of these and with one date: the same files give the same bytes.
core::Status writeZip(const std::string& folder, const std::string& archive);

}   // namespace angiopose::io
