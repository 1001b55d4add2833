#pragma once

#include "core/imaging/angiogram.h"
#include "core/support/result.h"

#include <string>

namespace angiopose::io {

struct SourceImage;

/// The run as an uncompressed 16-bit X-Ray Angiographic Image (PS3.3 A.14) in memory: another instance than the one it
/// was read from, in another series of the same study. UIDs follow from the content, so the same run gives the same
/// bytes. `source`: the image it is made of, referred to where it is not null. Fails when frames are missing, differ in
/// size or are not finite.
core::Result<std::string> dicomText(const core::Angiogram& angiogram, const SourceImage* source = nullptr);

}   // namespace angiopose::io