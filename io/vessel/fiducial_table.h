#pragma once

#include "io/vessel/fiducial.h"

namespace angiopose::io {

/// `.fcsv`: comments that say the coordinate system (0 or RAS, 1 or LPS; RAS where nothing does) and the columns, then
/// a point a line.
core::Result<std::vector<Fiducial>> parseFiducialTable(std::string_view text, const std::string& path);

std::string fiducialTable(const std::vector<Fiducial>& fiducials);

/// The fiducials among Slicer's markups; the curves are left to parseMarkups.
core::Result<std::vector<Fiducial>> parseFiducialMarkups(std::string_view json, const std::string& path);

std::string fiducialMarkups(const std::vector<Fiducial>& fiducials);

}   // namespace angiopose::io
