#pragma once

#include "core/imaging/angiogram.h"
#include "core/support/result.h"

#include <string>

namespace angiopose::io {

/// The run as an uncompressed 16-bit X-Ray Angiographic Image (PS3.3 A.14) in memory. UIDs follow from the content, so
/// the same run gives the same bytes. Fails when frames are missing, differ in size or are not finite.
core::Result<std::string> dicomText(const core::Angiogram& angiogram);

}   // namespace angiopose::io