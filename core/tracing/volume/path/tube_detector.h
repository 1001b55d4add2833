#pragma once

#include "core/imaging/volume.h"

#include <Eigen/Core>
#include <array>
#include <vector>

namespace angiopose::core {

/// Appearance of a vessel in a scan, as intensity levels of the scan.
struct VesselAppearance {
    double blood = 1.0;   ///< level of the lumen
    double tissue = 0.0;   ///< level of the surroundings; below `blood`
};

/// Resemblance of a voxel to the center of a tube.
struct TubeResemblance {
    double fraction = 0.0;   ///< 0…1, from the directions that are darker on both sides, at the best distance
    double shellMm = 0.0;   ///< best distance, within which the wall lies
};

/// Measures how much the voxels of a scan resemble the inside of a vessel. The volume must outlive this object.
class TubeDetector {
public:
    /// Ignores tubes wider than `widestRadiusMm`.
    explicit TubeDetector(const Volume& volume, double widestRadiusMm = 13.0);

    const Volume& volume() const { return volume_; }

    /// Returns the most likely vessel voxel within `reachMm` of a position.
    Eigen::Vector3i bestVoxelNear(const Eigen::Vector3i& voxel, double reachMm) const;

    /// Returns the appearance at a voxel: lumen level from the voxel's own value, tissue level from its surroundings.
    VesselAppearance appearanceAt(const Eigen::Vector3i& voxel) const;

    /// Computes how much a voxel resembles the center of a tube; low in chambers and in walls.
    TubeResemblance tube(const Eigen::Vector3i& voxel, double tissue) const;

    /// Returns only `TubeResemblance::fraction`, which is faster to compute.
    double tubeResemblance(const Eigen::Vector3i& voxel, double tissue) const;

    /// Returns the values in 26 directions at the given distance.
    std::vector<double> valuesAround(const Eigen::Vector3i& voxel, double distanceMm) const;

    double valueAt(const Eigen::Vector3i& voxel) const;   ///< edge values are repeated beyond the boundary

private:
    /// Opposite pairs of positions at the same distance.
    struct Shell {
        double radiusMm = 0.0;
        std::vector<Eigen::Vector3i> steps;   ///< 13 steps; their opposites complete the pairs
        std::vector<std::ptrdiff_t> offsets;   ///< the same steps as offsets in voxel storage
        Eigen::Vector3i reach = Eigen::Vector3i::Zero();
    };
    int countDarkerPairs(const Shell& shell, const Eigen::Vector3i& voxel, double limit, int atLeast) const;

    const Volume& volume_;
    std::vector<Shell> shells_;
};

}   // namespace angiopose::core
