#pragma once

#include "core/support/result.h"
#include "io/dicom/dicom_file.h"
#include "io/dicom/dicom_item.h"

#include <string>

namespace angiopose::io {

/// Treatment of burned-in text.
enum class DrawnLetters { Reported, BlackedOut };

/// Stores the pixels of `file` in `to`: decoded, in grayscale, only visible values, because compressed streams and
/// unused bits can hide data. Looks for burned-in text in projections, not in slices. Reports changes and findings to
/// review in `warnings`. Fails if there is no image, or none that can be stored again.
core::Status copyPixels(const DicomFile& file, const std::string& path, DrawnLetters letters, DicomItem& to,
                        core::Messages& warnings);

/// Stores the voxels of a segmentation in `to`, bit by bit and without padding data. Fails if they are compressed or
/// incomplete.
core::Status copySegments(const DicomFile& file, const std::string& path, DicomItem& to);

}   // namespace angiopose::io
