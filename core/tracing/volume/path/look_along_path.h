#pragma once

#include "core/tracing/volume/path/path_ground.h"
#include "core/tracing/volume/voxels/cross_section.h"

#include <vector>

namespace angiopose::core {

/// What a vessel looks like along its path: brightness changes on the way, by the contrast's age or the coil, and what
/// lies around it too. The volume must outlive it.
class LookAlongPath {
public:
    /// Points in mm along the grid's axes.
    LookAlongPath(const PathGround& ground, const std::vector<Eigen::Vector3d>& pointsMm);

    /// Share of blood near the path: 0 as around the vessel, 1 as in it.
    double fill(const Eigen::Vector3d& pointMm) const;

    /// The same, which looks up once for all points within a millimetre what the vessel is like there. For one thread.
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
