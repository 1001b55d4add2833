#pragma once

#include "core/imaging/image2d.h"
#include "core/support/result.h"

#include <map>
#include <string>

namespace angiopose::io {

/// Writes an 8-bit sRGB PNG atomically; `texts` become PNG text chunks (provenance).
core::Status writePng(const core::ColorImage& image, const std::string& path,
                      const std::map<std::string, std::string>& texts = {});

/// Writes an 8-bit grey PNG (0 and 255).
core::Status writePng(const core::Mask2d& mask, const std::string& path);

}   // namespace angiopose::io