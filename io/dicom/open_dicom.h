#pragma once

#include "core/support/result.h"
#include "io/support/input_bytes.h"

#include <string>

namespace angiopose::io {

/// Opens a DICOM file, also one inside a gzip archive. Fails as `openInput` does, and on content that is not DICOM.
core::Result<InputBytes> openDicom(const std::string& path);

/// True for what `openDicom` opens.
bool isDicomFile(const std::string& path);

}   // namespace angiopose::io