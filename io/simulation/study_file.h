#pragma once

#include "core/simulation/study/simulated_study.h"
#include "core/support/result.h"

#include <string>

namespace angiopose::io {

/// Reads a simulated study (FORMATS §4, "format": "angiopose-study") and the trees that it names. Fails on any unknown,
/// missing or out-of-range value; the error names the file, the position and the key.
core::Result<core::SimulatedStudy> readStudy(const std::string& path);

}   // namespace angiopose::io
