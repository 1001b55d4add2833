#pragma once

#include "io/vessel/fiducial.h"

namespace angiopose::io {

/// Points of `.fcsv` or of the fiducials in `.mrk.json`, turned to LPS: each says its coordinate system. Points that
/// are not placed are left out. Fails where there are none.
core::Result<std::vector<Fiducial>> readFiducials(const std::string& path);

/// Whether a file is one of them, and none of curves.
bool isFiducialFile(const std::string& path);

/// Writes `.fcsv` (version 4.11, LPS) or `.mrk.json`, by extension.
core::Status writeFiducials(const std::vector<Fiducial>& fiducials, const std::string& path);

}   // namespace angiopose::io
