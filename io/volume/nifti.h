#pragma once

#include "core/support/result.h"
#include "io/volume/stored_volume.h"

#include <string>
#include <string_view>

namespace angiopose::io {

/// Returns true for the first (unpacked) bytes of a NIfTI-1, NIfTI-2 or Analyze header.
bool looksLikeNifti(std::string_view head);

/// Header bytes that `parseNifti` needs.
inline constexpr std::size_t niftiHeadSize = 544;

/// Parses the header of a NIfTI volume (single file or .hdr/.img pair) with the structures of the format's own library,
/// and converts RAS to LPS; `head` is unpacked. Scanner coordinates take precedence if the file has several systems; a
/// volume without any, as every Analyze volume, gives a warning.
core::Result<StoredVolume> parseNifti(std::string_view head, const std::string& path);

}   // namespace angiopose::io
