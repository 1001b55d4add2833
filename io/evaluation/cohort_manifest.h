#pragma once

#include "core/evaluation/own/evaluate_own_case.h"
#include "core/support/result.h"

#include <map>
#include <string>
#include <vector>

namespace angiopose::io {

/// Reads landmarks from CSV with the columns x, y, z (patient LPS, mm; other columns are ignored) or from Slicer
/// fiducials (`.fcsv`, `.mrk.json`).
core::Result<std::vector<Eigen::Vector3d>> readLandmarks(const std::string& path);

/// Reads point pairs from a table with the columns x, y, z (patient LPS, mm) and u, v (px; (0, 0) is the center of the
/// first pixel).
core::Result<std::vector<core::PointPair>> readPointPairs(const std::string& path);

/// User-supplied case with its reference data. Paths are absolute, resolved relative to the manifest's folder; empty if
/// not specified.
struct CohortEntry {
    int line = 0;   ///< line number in the manifest
    std::string casePath;
    std::string referencePath;   ///< pose file with the reference pose
    std::string deformedVesselsPath;   ///< vessel file with the true deformed vessels
    std::string landmarksPath;   ///< file with the target points for mTRE and mRPD
    std::string pointPairsPath;
    std::string initialPosePath;   ///< pose file with the initial pose; if empty, the pose of the case
    std::string condition = "all";
    int patient = 0;   ///< index of the patient, in order of first appearance
    std::map<std::string, std::string>
        methodPosePaths;   ///< pose files, keyed by the name of the method that determined the poses
};

/// Reads a table with a header row: `case`, and one of `reference` and `pairs` in each row; optionally `bent`,
/// `landmarks`, `start`, `condition`, `patient` (without it, every row is a separate patient) and, for poses of other
/// programs, `pose.NAME`. Ignores other columns. Errors name the line and the missing value.
core::Result<std::vector<CohortEntry>> readCohortManifest(const std::string& path);

}   // namespace angiopose::io
