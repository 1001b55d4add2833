#pragma once

#include "core/imaging/volume.h"
#include "core/support/message.h"

#include <Eigen/Core>
#include <optional>
#include <string_view>

namespace angiopose::io {

/// Larger volumes than this are refused: 4 GiB of 16-bit voxels.
inline constexpr std::size_t maxVoxels = std::size_t{1} << 31;

/// A geometry from the patient vectors between neighbouring voxels, or why there is none.
struct AxesResult {
    core::VolumeGeometry geometry;
    std::optional<core::Message> problem;   ///< with the remedy
};

/// `steps`: columns are the LPS vectors (mm) from a voxel to its neighbour along i, j, k. Rounding (up to 0.1°) off the
/// right angle is taken out; more is a problem, as are sizes below 2, steps of no length and numbers that are none.
AxesResult geometryFromSteps(const Eigen::Vector3i& size, const Eigen::Matrix3d& steps,
                             const Eigen::Vector3d& originInPatient);

/// Of the length that a header names. Says so where it is not known, and takes millimetres.
double millimetersPer(std::string_view unit, core::Messages& warnings);

/// Steps and origin of a RAS file in LPS.
inline Eigen::Matrix3d lpsFromRas(Eigen::Matrix3d steps)
{
    steps.topRows<2>() *= -1.0;
    return steps;
}
inline Eigen::Vector3d lpsFromRas(Eigen::Vector3d point)
{
    point.head<2>() *= -1.0;
    return point;
}

}   // namespace angiopose::io