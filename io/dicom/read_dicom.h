#pragma once

#include "core/imaging/angiogram.h"
#include "core/support/result.h"

#include <string>
#include <string_view>

namespace angiopose::io {

/// Reads an angiogram from the bytes of a DICOM file. Other modalities load with a warning and without geometry.
core::Result<core::Angiogram> readDicomAngiogram(std::string_view content, const std::string& path);

}   // namespace angiopose::io
