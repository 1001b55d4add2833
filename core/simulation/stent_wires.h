#pragma once

#include "core/vessel/vessel_tree.h"

namespace angiopose::core {

/// A stent of crossing helices that lies on a vessel's wall.
struct StentOptions {
    double startShare = 0.3;   ///< of the branch's length, as is the end
    double endShare = 0.7;
    int helices = 6;   ///< each way round
    double steepnessDeg = 45.0;   ///< of a wire to the axis
    double wireRadiusMm = 0.25;
};

/// Its wires, each as a branch. None for a branch of fewer than two points.
VesselTree stentWires(const VesselBranch& branch, const StentOptions& options = {});

}   // namespace angiopose::core