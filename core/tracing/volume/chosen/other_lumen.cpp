#include "core/tracing/volume/chosen/other_lumen.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr double wallMm = 4.0;   ///< a flap or a stent's wires, or two walls, and what they blur
constexpr double leastRadiusMm = 4.0;
constexpr double leastParallel = 0.85;   ///< cosine; pulmonary arteries cross the aorta

bool isLumen(const VoxelMask& lumen, const Eigen::Affine3d& voxelFromPatient, const Eigen::Vector3d& inPatient)
{
    const Eigen::Vector3i at = (voxelFromPatient * inPatient).array().round().cast<int>();
    return lumen.geometry.contains(at) && lumen.at(at.x(), at.y(), at.z()) != 0;
}

/// Mostly within.
bool holds(const VoxelMask& lumen, const Trunk& trunk)
{
    const Eigen::Affine3d voxelFromPatient = lumen.geometry.patientFromVoxel().inverse();
    const auto in = std::ranges::count_if(
        trunk.pointsInPatient, [&](const Eigen::Vector3d& point) { return isLumen(lumen, voxelFromPatient, point); });
    return 2 * in > static_cast<std::ptrdiff_t>(trunk.pointsInPatient.size());
}

Eigen::Vector3d directionAt(const Trunk& trunk, std::size_t n)
{
    const std::size_t last = trunk.pointsInPatient.size() - 1;
    return (trunk.pointsInPatient[std::min(n + 1, last)] - trunk.pointsInPatient[n - std::min<std::size_t>(n, 1)])
        .normalized();
}

/// No more than a wall away, and in the same direction.
bool isBeside(const Trunk& trunk, std::size_t at, const Trunk& other)
{
    const Eigen::Vector3d direction = directionAt(trunk, at);
    for (std::size_t n = 0; n < other.radiusMm.size(); ++n) {
        const double awayMm = (other.pointsInPatient[n] - trunk.pointsInPatient[at]).norm();
        if (awayMm <= trunk.radiusMm[at] + other.radiusMm[n] + wallMm &&
            std::abs(direction.dot(directionAt(other, n))) >= leastParallel) {
            return true;
        }
    }
    return false;
}

double besideMm(const Trunk& trunk, const std::vector<const Trunk*>& traced)
{
    double mm = 0.0;
    for (std::size_t n = 1; n < trunk.radiusMm.size(); ++n) {
        const bool isBesideTraced =
            std::ranges::any_of(traced, [&](const Trunk* other) { return isBeside(trunk, n, *other); });
        mm += isBesideTraced ? (trunk.pointsInPatient[n] - trunk.pointsInPatient[n - 1]).norm() : 0.0;
    }
    return mm;
}

}   // namespace

double besideLumenMm(const VoxelMask& lumen, const std::vector<GreatVessel>& greatVessels)
{
    std::vector<const Trunk*> traced;
    std::vector<std::vector<const Trunk*>> others;
    for (const GreatVessel& great : greatVessels) {
        others.emplace_back();
        for (const Trunk& trunk : great.trunks) {
            if (trunk.medianRadiusMm() >= leastRadiusMm) {
                (holds(lumen, trunk) ? traced : others.back()).push_back(&trunk);
            }
        }
    }
    double longestMm = 0.0;
    for (const std::vector<const Trunk*>& other : others) {
        double mm = 0.0;
        for (const Trunk* trunk : other) {
            mm += besideMm(*trunk, traced);
        }
        longestMm = std::max(longestMm, mm);
    }
    return longestMm;
}

}   // namespace angiopose::core