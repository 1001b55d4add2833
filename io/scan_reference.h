#pragma once

#include "core/support/result.h"
#include "io/dicom/objects/vessel_segmentation.h"

#include <string>

namespace angiopose::io {

/// Returns the DICOM identity of the scan in a file or folder: the images of its series. Empty if it is not DICOM.
/// Fails if the series is not present.
core::Result<ScanReference> readScanReference(const std::string& path, const std::string& seriesId);

}   // namespace angiopose::io
