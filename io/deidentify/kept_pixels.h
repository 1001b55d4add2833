#pragma once

#include "core/support/result.h"
#include "io/dicom/dicom_file.h"
#include "io/dicom/dicom_item.h"

#include <string>

namespace angiopose::io {

/// What becomes of letters that are drawn into pictures.
enum class DrawnLetters { Reported, BlackedOut };

/// Stores the pixels of `file` in `to`, decoded, grey, each value as it is shown and no bit besides: compressed streams
/// and unused bits can hold what nobody sees. Letters are looked for in projections, not in slices. What was changed or
/// is to be looked at goes to `warnings`. Fails where there is no image, or none that can be stored again.
core::Status copyPixels(const DicomFile& file, const std::string& path, DrawnLetters letters, DicomItem& to,
                        core::Messages& warnings);

/// Stores the voxels of a segmentation in `to`, bit by bit, and no bit besides. Fails where they are compressed or not
/// all there.
core::Status copySegments(const DicomFile& file, const std::string& path, DicomItem& to);

}   // namespace angiopose::io
