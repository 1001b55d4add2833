#pragma once

#include "core/support/result.h"

#include <map>
#include <string>
#include <vector>

namespace angiopose::io {

/// A case of one's own and what is known of it. Paths are absolute, or as the manifest's folder resolves them; empty:
/// not given.
struct OwnEntry {
    int line = 0;   ///< in the manifest
    std::string casePath;
    std::string referencePath;   ///< a pose file
    std::string bentPath;   ///< a vessel file: where bent vessels truly lay
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
