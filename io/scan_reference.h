#pragma once

#include "core/support/result.h"
#include "io/dicom/objects/vessel_segmentation.h"

#include <string>

namespace angiopose::io {

/// Returns the DICOM identity of the scan in a file or folder, that is, references to the images of its series; empty
/// if the scan is not DICOM. Fails if the series is absent.
core::Result<ScanReference> readScanReference(const std::string& path, const std::string& seriesId);

}   // namespace angiopose::io
