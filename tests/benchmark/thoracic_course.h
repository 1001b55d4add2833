#pragma once

#include "tests/benchmark/thoracic_scan.h"

#include "core/vessel/vessel_tree.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::benchmarks {

/// Relation of a branch segment outside the masks to the masks.
enum class OutsideKind {
    BothLumens,   ///< in the mask of one of the aorta's lumens, outside the mask of the aorta
    BeyondAnEnd,   ///< reached through the end of an artery's mask: the artery continues beyond its mask
    Elsewhere,   ///< left the mask through its side
};

/// A segment of a branch outside the masks.
struct OutsideRun {
    int branch = 0;
    double lengthMm = 0.0;
    double radiusMm = 0.0;   ///< median, like the value
    double value = 0.0;
    Eigen::Vector3d from = Eigen::Vector3d::Zero();
    Eigen::Vector3d to = Eigen::Vector3d::Zero();
    double farthestMm = 0.0;   ///< largest distance from the masks
    bool isArterial = false;   ///< as bright as the masked arteries: a vessel missing from the masks
    OutsideKind kind = OutsideKind::Elsewhere;
};

/// Course of the traced curves relative to the masks, in shares of their length.
struct Course {
    double lengthMm = 0.0;
    double inside = 0.0;   ///< within the masks
    double outsideArterial = 0.0;
    double outsideOther = 0.0;
    double insideOfJudged = 0.0;   ///< share inside, without the parts beyond ends; both lumens count as inside
    double covered = 0.0;   ///< share of the masks' axes along which a curve runs within the masks
    std::vector<OutsideRun> outside;
};

/// Computes the course of a tree. Axes outside `seen`, if given, need not be covered.
Course courseOf(const core::VesselTree& tree, const ThoracicScan& thorax, const core::VolumeGeometry* seen = nullptr);

}   // namespace angiopose::benchmarks
