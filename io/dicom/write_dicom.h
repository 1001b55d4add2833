#pragma once

#include "core/imaging/angiogram.h"
#include "core/support/result.h"

#include <string>

namespace angiopose::io {

struct SourceImage;

/// Encodes a cine run as an uncompressed 16-bit X-Ray Angiographic Image (PS3.3 A.14): a new instance in a new series
/// of the same study. UIDs are derived from the content, so equal runs give equal bytes. References `source`, from
/// which the run was derived, unless it is null. Fails if frames are missing, differ in size or are not finite.
core::Result<std::string> encodeDicomAngiogram(const core::Angiogram& angiogram, const SourceImage* source = nullptr);

}   // namespace angiopose::io
