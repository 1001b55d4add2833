#pragma once

#include "core/support/result.h"
#include "io/dicom/dicom_file.h"
#include "io/dicom/dicom_item.h"

#include <string>

namespace angiopose::io {

/// Specifies whether burned-in text is only reported or also masked.
enum class BurnedInTextPolicy { Reported, Masked };

/// Stores the pixels of `file` in `to`: decoded, in grayscale, and reduced to the visible values, because compressed
/// streams and unused bits can hide data. Looks for burned-in text in projection images, not in slices. Reports changes
/// and findings that need review in `warnings`. Fails if there is no image or the image cannot be stored again.
core::Status copyPixels(const DicomFile& file, const std::string& path, BurnedInTextPolicy letters, DicomItem& to,
                        core::Messages& warnings);

/// Stores the voxels of a segmentation in `to`, bit by bit and without data in the padding. Fails if the voxels are
/// compressed or incomplete.
core::Status copySegments(const DicomFile& file, const std::string& path, DicomItem& to);

}   // namespace angiopose::io
