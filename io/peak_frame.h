#pragma once

#include "core/imaging/angiogram.h"
#include "core/support/result.h"

#include <string>

namespace angiopose::io {

/// Specifies whether to search for the peak-opacification frame, which takes as long as tracing one frame. A caller
/// that knows the frame can skip the search; the first frame is then suggested.
enum class PeakFrameSearch { Enabled, Skipped };

/// Reads an angiogram like readAngiogram (angiogram_file.h), which always searches for the peak-opacification frame.
core::Result<core::Angiogram> readAngiogram(const std::string& path, PeakFrameSearch peak);

}   // namespace angiopose::io
