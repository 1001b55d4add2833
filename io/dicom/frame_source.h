#pragma once

#include "core/imaging/image2d.h"
#include "core/support/result.h"
#include "io/dicom/pixel_layout.h"

namespace io {

/// Frames of a DICOM file as stored values (colour as luminance), decoded one at a time to keep memory low.
/// Fails when pixels are missing or cannot be decoded: a part of an image is no image.
core::Result<std::vector<core::ImageF>> readFrames(const DicomFile& file, const PixelLayout& layout,
                                                   const std::string& path);

}   // namespace io
