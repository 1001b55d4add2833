#pragma once

#include "core/simulation/study/simulated_study.h"
#include "core/support/result.h"

#include <string>

namespace angiopose::io {

/// Reads a simulated study (FORMATS §4, "format": "angiopose-study"); trees it names are read, too. Fails naming file,
/// place and key: what is unknown, missing or out of range.
core::Result<core::SimulatedStudy> readStudy(const std::string& path);

}   // namespace angiopose::io
