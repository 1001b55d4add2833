#pragma once

#include "io/vessel/fiducial.h"

namespace angiopose::io {

/// Parses `.fcsv`: comments that state the coordinate system (0 or RAS, 1 or LPS; default RAS) and the columns,
/// followed by one point per line.
core::Result<std::vector<Fiducial>> parseFiducialTable(std::string_view text, const std::string& path);

std::string fiducialTable(const std::vector<Fiducial>& fiducials);

/// Parses the fiducials of a Slicer markups file; parseMarkups reads its curves.
core::Result<std::vector<Fiducial>> parseFiducialMarkups(std::string_view json, const std::string& path);

std::string fiducialMarkups(const std::vector<Fiducial>& fiducials);

}   // namespace angiopose::io
