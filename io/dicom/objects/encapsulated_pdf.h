#pragma once

#include "io/dicom/objects/secondary_capture.h"

#include <string_view>

namespace angiopose::io {

/// Encapsulates a PDF report, byte for byte, in a DICOM object (PS3.3 A.45.1). Fails if the content is not PDF.
core::Result<std::string> encapsulatedPdf(std::string_view pdf, const std::string& title, BurnedInIdentity identity,
                                          const SourceImage& source, const ObjectOrigin& origin);

}   // namespace angiopose::io
