#pragma once

#include "io/dicom/objects/secondary_capture.h"

#include <string_view>

namespace angiopose::io {

/// A report in PDF as a DICOM object (PS3.3 A.45.1), the bytes as they are. Fails where they are no PDF.
core::Result<std::string> encapsulatedPdf(std::string_view pdf, const std::string& title, BurnedInIdentity identity,
                                          const SourceImage& source, const ObjectOrigin& origin);

}   // namespace angiopose::io
