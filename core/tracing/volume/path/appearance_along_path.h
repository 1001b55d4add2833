#pragma once

#include "core/tracing/volume/path/tube_detector.h"
#include "core/tracing/volume/voxels/cross_section.h"

#include <vector>

namespace angiopose::core {

/// Appearance of a vessel along its path; follows changes in the intensity of the vessel (contrast timing, coil) and of
/// its surroundings. The volume must outlive this object.
class AppearanceAlongPath {
public:
    /// Measures the appearance at points in mm along the grid's axes.
    AppearanceAlongPath(const TubeDetector& detector, const std::vector<Eigen::Vector3d>& pointsMm);

    /// Returns the opacification near the path: 0 as in the surroundings, 1 as in the vessel.
    double opacification(const Eigen::Vector3d& pointMm) const;

    /// Returns a faster variant of `opacification`, with the vessel's appearance looked up once per cubic millimeter.
    /// Not thread-safe.
    PointOpacification cachedOpacification() const;

private:
    std::size_t nearest(const Eigen::Vector3d& pointMm) const;
    double opacification(const Eigen::Vector3d& pointMm, const VesselAppearance& appearance) const;
    void smoothAlongPath();

    const Volume& volume_;
    std::vector<Eigen::Vector3d> samplesMm_;
    std::vector<VesselAppearance> appearances_;
};

}   // namespace angiopose::core
