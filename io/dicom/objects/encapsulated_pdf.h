#pragma once

#include "io/dicom/objects/secondary_capture.h"

#include <string_view>

namespace angiopose::io {

/// A PDF report as a DICOM object (PS3.3 A.45.1) with unchanged bytes. Fails if they are not a PDF.
core::Result<std::string> encapsulatedPdf(std::string_view pdf, const std::string& title, BurnedInIdentity identity,
                                          const SourceImage& source, const ObjectOrigin& origin);

}   // namespace angiopose::io
