#pragma once

#include "core/imaging/angiogram.h"
#include "core/support/result.h"

#include <map>
#include <string>

namespace angiopose::io {

/// Atomically writes an 8-bit sRGB PNG. `texts` (provenance) are stored as PNG text chunks; `dotsPerInch`, if above 0,
/// sets the print size.
core::Status writePng(const core::ColorImage& image, const std::string& path,
                      const std::map<std::string, std::string>& texts = {}, double dotsPerInch = 0.0);

/// Writes a frame as a 16-bit grayscale PNG: unchanged if all values of the run are integers in 0…65535, otherwise
/// scaled by the same factor in all frames. The text chunk "Values" states how to compute values from gray levels.
core::Status writeGrayPng(const core::Angiogram& run, int frame, const std::string& path,
                          std::map<std::string, std::string> texts, double dotsPerInch = 0.0);

/// Writes a mask as an 8-bit grayscale PNG (0 and 255).
core::Status writePng(const core::Mask2d& mask, const std::string& path);

}   // namespace angiopose::io
