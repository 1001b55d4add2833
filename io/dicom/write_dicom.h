#pragma once

#include "core/imaging/angiogram.h"
#include "core/support/result.h"

#include <string>

namespace angiopose::io {

struct SourceImage;

/// The cine run as an uncompressed 16-bit X-Ray Angiographic Image (PS3.3 A.14) in memory: a new instance in another
/// series of the same study. UIDs derive from the content, so the same run gives the same bytes. `source`: the image it
/// was derived from, which is referenced if not null. Fails if frames are missing, differ in size or are not finite.
core::Result<std::string> dicomText(const core::Angiogram& angiogram, const SourceImage* source = nullptr);

}   // namespace angiopose::io
