#pragma once

#include "core/support/result.h"
#include "core/tracing/angiogram/run/subtract_run.h"

#include <string>

namespace angiopose::io {

/// Returns how to display a DICOM run: subtracted if the header specifies mask frames or their distance from the
/// contrast frames, unless it recommends native viewing (0028,1090). Includes the plan from `readSubtractionPlan`.
core::Result<core::RunProcessing> readRunProcessing(const std::string& path);

/// Reads the subtraction attributes of a DICOM run: the mask frames or their distance from the contrast frames, the
/// subpixel shift (Mask Module, PS3.3 C.7.6.10: the first item with AVG_SUB, TID or REV_TID) and the pixel intensity
/// relationship (0028,1040). Unspecified attributes remain unset for the user to choose; for other images the plan is
/// empty. Fails if the file cannot be read.
core::Result<core::SubtractionPlan> readSubtractionPlan(const std::string& path);

}   // namespace angiopose::io
