#pragma once

#include "core/evaluation/own/judge_own.h"
#include "core/support/result.h"

#include <map>
#include <string>
#include <vector>

namespace angiopose::io {

/// Landmarks from a comma-separated table with the columns x, y, z (patient LPS, mm; other columns are left alone), or
/// from Slicer's fiducials (`.fcsv`, `.mrk.json`).
core::Result<std::vector<Eigen::Vector3d>> readLandmarks(const std::string& path);

/// Pairs of points from a table with x, y, z (patient LPS, mm) and u, v (px; (0, 0) is the centre of the first pixel).
core::Result<std::vector<core::PointPair>> readPointPairs(const std::string& path);

/// A case of one's own and what is known of it. Paths are absolute, or as the manifest's folder resolves them; empty:
/// not given.
struct OwnEntry {
    int line = 0;   ///< in the manifest
    std::string casePath;
    std::string referencePath;   ///< a pose file
    std::string deformedPath;   ///< a vessel file: where bent vessels truly lay
    std::string landmarksPath;   ///< targets of mTRE and mRPD
    std::string pairsPath;
    std::string startPath;   ///< a pose file; empty: the case's pose
    std::string condition = "all";
    int patient = 0;   ///< the same number, the same patient: counted by first appearance
    std::map<std::string, std::string> foundPaths;   ///< pose files by the name of what found them
};

/// Reads a table with a header row: `case`, and one of `reference` and `pairs` in each row; where wanted `bent`,
/// `landmarks`, `start`, `condition`, `patient` (each row its own without that column) and, for poses found elsewhere,
/// `pose.NAME`. Other columns are left alone. Fails naming the line and what it lacks.
core::Result<std::vector<OwnEntry>> readOwnManifest(const std::string& path);

}   // namespace angiopose::io
