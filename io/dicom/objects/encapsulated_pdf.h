#pragma once

#include "io/dicom/objects/secondary_capture.h"

#include <string_view>

namespace angiopose::io {

/// Returns a DICOM object that encapsulates a PDF report byte for byte (PS3.3 A.45.1). Fails if `pdf` is not PDF.
core::Result<std::string> encodeEncapsulatedPdf(std::string_view pdf, const std::string& title,
                                                BurnedInIdentity identity, const SourceImage& source,
                                                const ObjectOrigin& origin);

}   // namespace angiopose::io
