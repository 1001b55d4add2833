#pragma once

#include "core/support/result.h"

#include <string>
#include <string_view>

namespace io {

/// Writes a file so that it is either the old or the new one, whole: temporary file beside it, flush, rename.
core::Status writeAtomically(const std::string& path, std::string_view content);

}   // namespace io
