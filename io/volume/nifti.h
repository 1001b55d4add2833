#pragma once

#include "core/support/result.h"
#include "io/volume/stored_volume.h"

#include <string>
#include <string_view>

namespace angiopose::io {

/// True for the first bytes of a NIfTI-1, NIfTI-2 or Analyze header (unpacked).
bool looksLikeNifti(std::string_view head);

/// Bytes of a header that `parseNifti` needs.
inline constexpr std::size_t niftiHeadSize = 544;

/// Header of a NIfTI volume (single file or .hdr/.img pair), RAS turned to LPS, by the structures of the format's own
/// library; `head` is unpacked. The scanner's coordinates win where the file knows several; a volume without any, as
/// every Analyze volume is, says so in a warning.
core::Result<StoredVolume> parseNifti(std::string_view head, const std::string& path);

}   // namespace angiopose::io
