#pragma once

#include "core/support/result.h"
#include "io/support/read_observer.h"
#include "io/vessel/line_set.h"

#include <string>

namespace angiopose::io {

struct VesselTreeReadOptions {
    double unitMm = 0.0;   ///< length of one unit; 0: what the file states, else 1 mm. Slicer curves keep theirs
};

/// Centreline tree from VTP/VTU, legacy VTK (poly-data or unstructured grid), CSV, SWC or Slicer curves (FORMATS §4),
/// patient LPS mm. RAS files are converted, and stretches that several lines share (VMTK) come once, cut at
/// bifurcations. Branch ids are the file's where they are unique, else 1…n in file order. Fails with file, problem and
/// remedy.
core::Result<ReadTree> readTree(const std::string& path, const VesselTreeReadOptions& options = {},
                                const ReadObserver& observe = {});

/// The tree alone.
core::Result<core::VesselTree> readVesselTree(const std::string& path, const VesselTreeReadOptions& options = {},
                                              const ReadObserver& observe = {});

/// Writes VTP, CSV, SWC or Slicer curves (.mrk.json, without radii), by extension, atomically.
core::Status writeVesselTree(const core::VesselTree& tree, const std::string& path);

}   // namespace angiopose::io