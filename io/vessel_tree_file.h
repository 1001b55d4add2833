#pragma once

#include "core/support/result.h"
#include "core/vessel/vessel_tree.h"

#include <string>

namespace io {

struct VesselTreeReadOptions {
    double swcUnitMm = 1.0;   ///< length of one unit of an SWC file
};

/// Centreline tree from VTP, legacy VTK (poly-data or unstructured grid), CSV or SWC (FORMATS §4), patient LPS mm.
/// RAS files are converted. Fails with file, problem and remedy.
core::Result<core::VesselTree> readVesselTree(const std::string& path, const VesselTreeReadOptions& options = {});

/// Writes VTP or CSV, by extension, atomically.
core::Status writeVesselTree(const core::VesselTree& tree, const std::string& path);

}   // namespace io
