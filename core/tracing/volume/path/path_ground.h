#pragma once

#include "core/imaging/volume.h"

#include <Eigen/Core>
#include <array>
#include <vector>

namespace angiopose::core {

/// What vessels of a scan look like around two places that somebody says lie in one.
struct VesselLook {
    double blood = 1.0;   ///< value of the scan
    double tissue = 0.0;   ///< around it; below `blood`
};

/// How much of a tube's middle a voxel is.
struct TubeLook {
    double share =
        0.0;   ///< 0…1: in how many directions the scan is darker on both sides, at the distance where most are
    double shellMm = 0.0;   ///< that distance: the wall lies within it
};

/// How much like the inside of a vessel the voxels of a scan are. The volume must outlive it.
class PathGround {
public:
    /// Tubes wider than the radius are none.
    explicit PathGround(const Volume& volume, double widestRadiusMm = 13.0);

    const Volume& volume() const { return volume_; }

    /// The likeliest voxel of a vessel around a place, within `reachMm`.
    Eigen::Vector3i likeliestNear(const Eigen::Vector3i& voxel, double reachMm) const;

    /// Blood at the voxel, tissue by what lies around it.
    VesselLook lookAt(const Eigen::Vector3i& voxel) const;

    /// How much a voxel is the middle of a tube; neither in a chamber nor in a wall.
    TubeLook tube(const Eigen::Vector3i& voxel, double tissue) const;

    /// The share alone, which is found sooner.
    double tubeShare(const Eigen::Vector3i& voxel, double tissue) const;

    /// Values in 26 directions at a distance.
    std::vector<double> valuesAround(const Eigen::Vector3i& voxel, double distanceMm) const;

    double valueAt(const Eigen::Vector3i& voxel) const;   ///< beyond the rim the last voxels go on

private:
    /// Pairs of opposite places at one distance.
    struct Shell {
        double radiusMm = 0.0;
        std::vector<Eigen::Vector3i> steps;   ///< 13, and their opposites
        std::vector<std::ptrdiff_t> offsets;   ///< the same among the voxels as stored
        Eigen::Vector3i reach = Eigen::Vector3i::Zero();
    };
    int darkerPairs(const Shell& shell, const Eigen::Vector3i& voxel, double limit, int atLeast) const;

    const Volume& volume_;
    std::vector<Shell> shells_;
};

}   // namespace angiopose::core
