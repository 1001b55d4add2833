#pragma once

#include "io/vessel/fiducial.h"

namespace angiopose::io {

/// Reads the points of an `.fcsv` file or the fiducials of an `.mrk.json` file and converts them from the coordinate
/// system stated in the file to LPS. Skips points that are not placed. Fails if no points remain.
core::Result<std::vector<Fiducial>> readFiducials(const std::string& path);

/// Returns whether an `.fcsv` or `.mrk.json` file contains fiducials rather than curves.
bool isFiducialFile(const std::string& path);

/// Writes `.fcsv` (version 4.11, LPS) or `.mrk.json`, depending on the extension.
core::Status writeFiducials(const std::vector<Fiducial>& fiducials, const std::string& path);

}   // namespace angiopose::io
