#pragma once

#include "core/tracing/volume/path/path_ground.h"
#include "core/tracing/volume/voxels/cross_section.h"

#include <vector>

namespace angiopose::core {

/// Appearance of a vessel along its path; follows changes in the intensity of the vessel (contrast timing, coil) and of
/// its surroundings. The volume must outlive this object.
class LookAlongPath {
public:
    /// Measures the appearance at points in mm along the grid's axes.
    LookAlongPath(const PathGround& ground, const std::vector<Eigen::Vector3d>& pointsMm);

    /// Returns the opacification near the path: 0 as in the surroundings, 1 as in the vessel.
    double fill(const Eigen::Vector3d& pointMm) const;

    /// Faster variant of `fill`: looks up the vessel's appearance once per cubic millimeter. Not thread-safe.
    BloodFill quickFill() const;

private:
    std::size_t nearest(const Eigen::Vector3d& pointMm) const;
    double fill(const Eigen::Vector3d& pointMm, const VesselLook& look) const;
    void steady();

    const Volume& volume_;
    std::vector<Eigen::Vector3d> placesMm_;
    std::vector<VesselLook> looks_;
};

}   // namespace angiopose::core
