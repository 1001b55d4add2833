#pragma once

#include "core/imaging/angiogram.h"
#include "core/support/result.h"

#include <map>
#include <string>

namespace angiopose::io {

/// Writes an 8-bit sRGB PNG atomically. `texts` become PNG text chunks (provenance); `dotsPerInch` above 0 sets the
/// print size.
core::Status writePng(const core::ColorImage& image, const std::string& path,
                      const std::map<std::string, std::string>& texts = {}, double dotsPerInch = 0.0);

/// Writes a frame as a 16-bit gray PNG: unchanged if the whole run holds integers of 0…65535, otherwise stretched with
/// one scale for all frames. The text chunk "Values" states how values follow from gray levels.
core::Status writeGrayPng(const core::Angiogram& run, int frame, const std::string& path,
                          std::map<std::string, std::string> texts, double dotsPerInch = 0.0);

/// Writes an 8-bit gray PNG (0 and 255).
core::Status writePng(const core::Mask2d& mask, const std::string& path);

}   // namespace angiopose::io