#pragma once

#include "core/imaging/angiogram.h"
#include "core/support/result.h"

#include <map>
#include <string>

namespace angiopose::io {

/// Writes an 8-bit sRGB PNG atomically; `texts` become PNG text chunks (provenance), `dotsPerInch` above 0 its size in
/// print.
core::Status writePng(const core::ColorImage& image, const std::string& path,
                      const std::map<std::string, std::string>& texts = {}, double dotsPerInch = 0.0);

/// Writes a frame's grey values as 16-bit PNG: as they are where the whole run has integers of 0…65535, else stretched,
/// for all frames alike. A text chunk "Values" says how values follow from grey.
core::Status writeGrayPng(const core::Angiogram& run, int frame, const std::string& path,
                          std::map<std::string, std::string> texts, double dotsPerInch = 0.0);

/// Writes an 8-bit grey PNG (0 and 255).
core::Status writePng(const core::Mask2d& mask, const std::string& path);

}   // namespace angiopose::io