#pragma once

#include <Eigen/Core>
#include <functional>

namespace angiopose::core {

/// How far a place is filled with blood: 0 tissue, 1 blood, one half at the wall. Points in mm along the grid's axes.
using BloodFill = std::function<double(const Eigen::Vector3d& pointMm)>;

/// Shape of the lumen across a vessel.
struct CrossSection {
    Eigen::Vector3d centerMm = Eigen::Vector3d::Zero();   ///< of the area within the wall
    double radiusMm = 0.0;   ///< of the disc of the same area
    double closed = 0.0;   ///< share of the rays that meet a wall, a flattened vessel's far one included
    double trust = 0.0;   ///< 0: no section found; near 1: the wall is found all around and as round as a vessel is
};

/// Where the section is looked for, and how finely.
struct SectionPlane {
    Eigen::Vector3d pointMm = Eigen::Vector3d::Zero();
    Eigen::Vector3d tangent = Eigen::Vector3d::UnitZ();
    double expectedRadiusMm = 1.0;   ///< rays reach twice as far and two voxels
    double voxelMm = 1.0;
};

/// Sends rays across the vessel to its wall, found below the voxel where the fill passes one half (or half of what a
/// vessel thinner than the scanner's resolution reaches). The width of such a thin vessel follows from how much blood
/// its section holds, which blurring keeps.
CrossSection crossSection(const SectionPlane& plane, const BloodFill& fill);

}   // namespace angiopose::core