#pragma once

#include "core/support/result.h"

#include <string>
#include <string_view>

namespace angiopose::io {

/// True for what begins as a TIFF.
bool looksLikeTiff(std::string_view content);

/// A TIFF with the pixels of its pages as they decode, bit by bit, and only what is needed to show them: no texts,
/// times, Exif, GPS, XMP, profiles, private tags, thumbnails, nor what lies between or behind. Pages that were
/// compressed are compressed without loss. Fails on kinds that `readTiff` does not read either.
core::Result<std::string> strippedTiff(std::string_view tiff, const std::string& path);

}   // namespace angiopose::io
