#pragma once

#include "core/support/result.h"
#include "io/dicom/objects/vessel_segmentation.h"

#include <string>

namespace angiopose::io {

/// How DICOM knows the scan of a file or folder: the images of its series. Empty where it is no DICOM. Fails where the
/// series is not there.
core::Result<ScanReference> readScanReference(const std::string& path, const std::string& seriesId);

}   // namespace angiopose::io
