#pragma once

#include "core/imaging/angiogram.h"
#include "core/support/result.h"

#include <string>

namespace angiopose::io {

/// Reads an angiogram from PNG, TIFF, JPEG or DICOM XA (single- or multi-frame, also compressed). DICOM files also
/// supply the geometry tags of ALGORITHMS §5.1 with their origin. Converts color to grayscale with a warning. Errors
/// name the file, the problem and the remedy.
core::Result<core::Angiogram> readAngiogram(const std::string& path);

/// Returns whether readAngiogram may be able to read the file: DICOM (also gzip-compressed), PNG, TIFF or JPEG.
bool looksLikeImageFile(const std::string& path);

/// Writes the frames as an uncompressed multi-frame 16-bit DICOM XA with the geometry of `angiogram.cArm`.
core::Status writeAngiogram(const core::Angiogram& angiogram, const std::string& path);

}   // namespace angiopose::io
