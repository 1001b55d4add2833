#pragma once

#include <Eigen/Core>
#include <functional>

namespace angiopose::core {

/// Opacification at a point in mm along the grid's axes: 0 in tissue, 1 in the lumen, 0.5 at the wall.
using PointOpacification = std::function<double(const Eigen::Vector3d& pointMm)>;

/// Cross-section of a vessel lumen.
struct CrossSection {
    Eigen::Vector3d centerMm = Eigen::Vector3d::Zero();   ///< centroid of the area within the wall
    double radiusMm = 0.0;   ///< radius of a disc of equal area
    double closedFraction = 0.0;   ///< fraction of rays that meet a wall, including the far wall of a flattened vessel
    double confidence = 0.0;   ///< 0 if no section was found, near 1 for a round section with walls all around
};

/// Position, orientation and resolution of a cross-section.
struct SectionPlane {
    Eigen::Vector3d pointMm = Eigen::Vector3d::Zero();
    Eigen::Vector3d tangent = Eigen::Vector3d::UnitZ();
    double expectedRadiusMm = 1.0;   ///< the rays reach twice as far plus two voxels
    double voxelMm = 1.0;
};

/// Casts rays across the vessel and locates the wall with subvoxel accuracy where the opacification passes one half (or
/// half the maximum of a vessel thinner than the scanner's resolution). The width of such a thin vessel follows from
/// the integrated opacification of its section, which blurring preserves.
CrossSection measureCrossSection(const SectionPlane& plane, const PointOpacification& opacification);

}   // namespace angiopose::core
