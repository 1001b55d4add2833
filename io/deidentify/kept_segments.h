#pragma once

#include "core/support/result.h"
#include "io/dicom/dicom_file.h"
#include "io/dicom/dicom_item.h"

#include <string>

namespace angiopose::io {

/// Stores the voxels of a segmentation in `to`, bit by bit, and no bit besides. Fails where they are compressed or not
/// all there.
core::Status copySegments(const DicomFile& file, const std::string& path, DicomItem& to);

}   // namespace angiopose::io
