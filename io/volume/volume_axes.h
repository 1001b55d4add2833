#pragma once

#include "core/imaging/volume.h"
#include "core/support/message.h"

#include <Eigen/Core>
#include <optional>
#include <string_view>

namespace angiopose::io {

/// Maximum number of voxels of a volume: 4 GiB of 16-bit voxels.
inline constexpr std::size_t maxVoxels = std::size_t{1} << 31;

/// A geometry built from the patient vectors between neighboring voxels, or the reason why there is none.
struct AxesResult {
    core::VolumeGeometry geometry;
    std::optional<core::Message> problem;   ///< reason, with the remedy
};

/// Builds a geometry from `steps`: column k is the LPS vector (mm) from a voxel to its neighbor along axis k. Corrects
/// axes that are up to 0.1° from orthogonal; larger deviations, sizes below 2 and zero or non-finite steps are errors.
AxesResult geometryFromSteps(const Eigen::Vector3i& size, const Eigen::Matrix3d& steps,
                             const Eigen::Vector3d& originInPatient);

/// Returns the length in mm of the unit that a header names. Warns if the unit is unknown, and assumes mm.
double millimetersPer(std::string_view unit, core::Messages& warnings);

/// Converts the steps or the origin of a RAS file to LPS.
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
