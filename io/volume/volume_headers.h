#pragma once

#include "core/imaging/volume.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace angiopose::io {

/// Returns a NIfTI-1 header of 352 bytes for 16-bit voxels (`isLabel`: unsigned).
std::string niftiHeader(const core::VolumeGeometry& geometry, double slope, double intercept, bool isLabel);

/// Returns an NRRD header for attached gzip data, little endian. `type`: "short", "unsigned short", "float".
std::string nrrdHeader(const core::VolumeGeometry& geometry, std::string_view type);

/// Returns a MetaImage header for local voxels packed into `packedBytes`. `type`: "MET_SHORT", "MET_USHORT",
/// "MET_FLOAT".
std::string metaImageHeader(const core::VolumeGeometry& geometry, std::string_view type, std::size_t packedBytes);

}   // namespace angiopose::io