#pragma once

#include "core/imaging/angiogram.h"
#include "core/support/result.h"

#include <string>

namespace angiopose::io {

/// Writes an angiogram like writeAngiogram, with a reference to the DICOM instance from which it was derived; omits the
/// reference if the source is not DICOM.
core::Status writeDerivedAngiogram(const core::Angiogram& angiogram, const std::string& path,
                                   const std::string& sourcePath);

}   // namespace angiopose::io
