#pragma once

#include "core/support/result.h"
#include "io/support/read_observer.h"
#include "io/vessel/line_set.h"

#include <string>

namespace angiopose::io {

struct VesselTreeReadOptions {
    double unitMm = 0.0;   ///< length of one unit; 0: as the file states, otherwise 1 mm. Slicer curves keep their own
};

/// Reads a centerline tree from VTP/VTU, legacy VTK (poly-data or unstructured grid), CSV, SWC or Slicer curves
/// (FORMATS §4), patient LPS mm. Converts RAS files, and keeps stretches shared by several lines (VMTK) once, cut at
/// bifurcations. Branch ids are those of the file if unique, otherwise 1…n in file order. Fails with file, problem and
/// remedy.
core::Result<ReadTree> readTree(const std::string& path, const VesselTreeReadOptions& options = {},
                                const ReadObserver& observe = {});

/// Reads only the tree.
core::Result<core::VesselTree> readVesselTree(const std::string& path, const VesselTreeReadOptions& options = {},
                                              const ReadObserver& observe = {});

/// Writes VTP, CSV, SWC or Slicer curves (.mrk.json, without radii), depending on the extension, atomically.
core::Status writeVesselTree(const core::VesselTree& tree, const std::string& path);

}   // namespace angiopose::io