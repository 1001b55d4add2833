#pragma once

#include "core/imaging/angiogram.h"
#include "core/support/result.h"

#include <string>

namespace angiopose::io {

/// To find the fullest frame of a run takes as long as to trace one: who knows the frame can do without, and the run
/// then suggests its first.
enum class PeakFrame { Sought, NotNeeded };

/// readAngiogram (angiogram_file.h), which seeks it.
core::Result<core::Angiogram> readAngiogram(const std::string& path, PeakFrame peak);

}   // namespace angiopose::io
