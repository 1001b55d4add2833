#pragma once

#include "tests/benchmark/thoracic_scan.h"

#include "core/vessel/vessel_tree.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::benchmarks {

/// What the masks can say about a stretch of a branch outside them.
enum class OutsideKind {
    BothLumens,   ///< in the mask of one of the aorta's lumens, where that of the aorta leaves it out
    BeyondAnEnd,   ///< reached through the end of an artery's mask, or from there: an artery goes on where its mask
                   ///< ends
    Elsewhere,   ///< through the side of a mask
};

/// A stretch of a branch outside the masks.
struct OutsideRun {
    int branch = 0;
    double lengthMm = 0.0;
    double radiusMm = 0.0;   ///< median, as are the values
    double value = 0.0;
    Eigen::Vector3d from = Eigen::Vector3d::Zero();
    Eigen::Vector3d to = Eigen::Vector3d::Zero();
    double farthestMm = 0.0;   ///< from the masks
    bool isArterial = false;   ///< as bright as the masked arteries are: a vessel that the masks leave out
    OutsideKind kind = OutsideKind::Elsewhere;
};

/// Where traced curves run; shares of their length.
struct Course {
    double lengthMm = 0.0;
    double inside = 0.0;   ///< within the masks
    double outsideArterial = 0.0;
    double outsideOther = 0.0;
    double insideOfJudged = 0.0;   ///< of the curve without what lies beyond ends; both lumens count as inside
    double covered = 0.0;   ///< share of the masks' axes beside which a curve runs within the masks
    std::vector<OutsideRun> outside;
};

/// Axes outside `seen` (if given) do not count as to be covered.
Course courseOf(const core::VesselTree& tree, const ThoracicScan& thorax, const core::VolumeGeometry* seen = nullptr);

}   // namespace angiopose::benchmarks