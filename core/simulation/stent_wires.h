#pragma once

#include "core/vessel/vessel_tree.h"

namespace angiopose::core {

/// A stent of crossing helices on the wall of a vessel.
struct StentOptions {
    double startShare = 0.3;   ///< fraction of the branch's length, as for the end
    double endShare = 0.7;
    int helices = 6;   ///< per direction of rotation
    double steepnessDeg = 45.0;   ///< angle between a strut and the axis
    double wireRadiusMm = 0.25;
};

/// Returns the stent struts, each as a branch. Empty for a branch with fewer than two points.
VesselTree stentWires(const VesselBranch& branch, const StentOptions& options = {});

}   // namespace angiopose::core