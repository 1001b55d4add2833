#pragma once

#include "core/evaluation/own/judge_own.h"
#include "core/support/result.h"

#include <string>
#include <vector>

namespace angiopose::io {

/// Landmarks from a comma-separated table with the columns x, y, z (patient LPS, mm; other columns are left alone), or
/// from Slicer's fiducials (`.fcsv`, `.mrk.json`).
core::Result<std::vector<Eigen::Vector3d>> readLandmarks(const std::string& path);

/// Pairs of points from a table with x, y, z (patient LPS, mm) and u, v (px; (0, 0) is the centre of the first pixel).
core::Result<std::vector<core::PointPair>> readPointPairs(const std::string& path);

}   // namespace angiopose::io
