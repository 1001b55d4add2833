#pragma once

#include "core/support/result.h"
#include "io/support/read_observer.h"
#include "io/vessel/line_set.h"

#include <string>

namespace angiopose::io {

struct VesselTreeReadOptions {
    double unitMm = 0.0;   ///< length of one unit, mm; if 0, as stated in the file or 1 mm. Ignored for Slicer curves
};

/// Reads a centerline tree from VTP/VTU, legacy VTK (PolyData or UnstructuredGrid), CSV, SWC or Slicer curves (FORMATS
/// §4), in patient LPS mm. Converts RAS files. Keeps one copy of a section that several lines share (VMTK), cut at
/// bifurcations. Branch IDs are those of the file if unique, otherwise 1…n in file order. Errors name the file, the
/// problem and the remedy.
core::Result<LoadedTree> readTree(const std::string& path, const VesselTreeReadOptions& options = {},
                                  const ReadObserver& observe = {});

/// Reads a centerline tree like readTree and returns only the tree.
core::Result<core::VesselTree> readVesselTree(const std::string& path, const VesselTreeReadOptions& options = {},
                                              const ReadObserver& observe = {});

/// Atomically writes VTP, CSV, SWC or Slicer curves (.mrk.json, without radii), depending on the extension.
core::Status writeVesselTree(const core::VesselTree& tree, const std::string& path);

}   // namespace angiopose::io
