#pragma once

#include "core/support/result.h"
#include "io/volume/stored_volume.h"

#include <string>
#include <string_view>

namespace angiopose::io {

/// Whether `head`, the first decompressed bytes of a file, is a NIfTI-1, NIfTI-2 or Analyze header.
bool looksLikeNifti(std::string_view head);

/// Number of header bytes that `parseNifti` requires.
inline constexpr std::size_t niftiHeadSize = 544;

/// Parses the header of a NIfTI volume (single file or .hdr/.img pair) with the structures of nifti_clib and converts
/// RAS to LPS; `head` is decompressed. Scanner coordinates take precedence if the file has several coordinate systems.
/// A volume without any, such as every Analyze volume, causes a warning.
core::Result<StoredVolume> parseNifti(std::string_view head, const std::string& path);

}   // namespace angiopose::io
