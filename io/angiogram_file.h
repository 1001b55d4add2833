#pragma once

#include "core/imaging/angiogram.h"
#include "core/support/result.h"

#include <string>

namespace angiopose::io {

/// Angiogram from PNG, TIFF, JPEG or DICOM XA (single and multi-frame, compressed too), with the geometry tags of
/// ALGORITHMS §5.1 and their origin. Colour becomes grey with a warning. Fails with file, problem and remedy.
core::Result<core::Angiogram> readAngiogram(const std::string& path);

/// True for DICOM (packed with gzip too) and for pictures: what readAngiogram may read.
bool looksLikeImageFile(const std::string& path);

/// Writes the frames as an uncompressed multi-frame 16-bit DICOM XA with the geometry of `angiogram.cArm`.
core::Status writeAngiogram(const core::Angiogram& angiogram, const std::string& path);

}   // namespace angiopose::io