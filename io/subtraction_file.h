#pragma once

#include "core/support/result.h"
#include "core/tracing/angiogram/run/subtract_run.h"

#include <string>

namespace angiopose::io {

/// How a DICOM run is to be shown: subtracted where its header names mask frames or an interval to them, unless it
/// recommends native viewing (0028,1090); with what `readSubtractionPlan` reads.
core::Result<core::RunTreatment> readTreatment(const std::string& path);

/// What a DICOM run says about its subtraction: the mask frames or the interval to them, and their sub-pixel shift
/// (Mask Module, PS3.3 C.7.6.10: the first item that is AVG_SUB, TID or REV_TID) and the pixel relation (0028,1040).
/// Whatever it does not say, and everything for other images, is as in an empty plan: to be chosen. Fails when the file
/// cannot be read.
core::Result<core::SubtractionPlan> readSubtractionPlan(const std::string& path);

}   // namespace angiopose::io