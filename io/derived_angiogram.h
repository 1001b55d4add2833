#pragma once

#include "core/imaging/angiogram.h"
#include "core/support/result.h"

#include <string>

namespace angiopose::io {

/// As writeAngiogram, and the file refers to the DICOM instance that it was made of; a picture is none.
core::Status writeDerivedAngiogram(const core::Angiogram& angiogram, const std::string& path,
                                   const std::string& sourcePath);

}   // namespace angiopose::io
