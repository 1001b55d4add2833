#pragma once

#include "core/vessel/vessel_tree.h"

namespace angiopose::core {

/// A stent of crossing helical struts on the wall of a vessel.
struct StentOptions {
    double startFraction = 0.3;   ///< start of the stent as a fraction of the branch length; `endFraction` is its end
    double endFraction = 0.7;
    int helices = 6;   ///< number of helices in each direction of rotation
    double steepnessDeg = 45.0;   ///< angle between a strut and the vessel axis
    double wireRadiusMm = 0.25;
};

/// Returns the stent struts, each as a branch; empty for a branch with fewer than two points.
VesselTree stentWires(const VesselBranch& branch, const StentOptions& options = {});

}   // namespace angiopose::core
