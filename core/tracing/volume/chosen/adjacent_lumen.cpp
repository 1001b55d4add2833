#include "core/tracing/volume/chosen/adjacent_lumen.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr double wallMm = 4.0;   ///< maximum thickness of a dissection flap, stent struts or two walls, including blur
constexpr double minRadiusMm = 4.0;
constexpr double minParallel = 0.85;   ///< minimum cosine of the angle; pulmonary arteries cross the aorta

bool isLumen(const VoxelMask& lumen, const Eigen::Affine3d& voxelFromPatient, const Eigen::Vector3d& pointInPatient)
{
    const Eigen::Vector3i at = (voxelFromPatient * pointInPatient).array().round().cast<int>();
    return lumen.geometry.contains(at) && lumen.at(at.x(), at.y(), at.z()) != 0;
}

/// Returns whether most of the trunk lies inside the lumen.
bool containsTrunk(const VoxelMask& lumen, const Trunk& trunk)
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

/// Returns whether the trunks run parallel at this point, at most one wall apart.
bool isAdjacent(const Trunk& trunk, std::size_t at, const Trunk& other)
{
    const Eigen::Vector3d direction = directionAt(trunk, at);
    for (std::size_t n = 0; n < other.radiusMm.size(); ++n) {
        const double distanceMm = (other.pointsInPatient[n] - trunk.pointsInPatient[at]).norm();
        if (distanceMm <= trunk.radiusMm[at] + other.radiusMm[n] + wallMm &&
            std::abs(direction.dot(directionAt(other, n))) >= minParallel) {
            return true;
        }
    }
    return false;
}

AdjacentLumen measureAdjacency(const std::vector<const Trunk*>& trunks, const std::vector<const Trunk*>& traced)
{
    AdjacentLumen candidate;
    std::vector<Eigen::Vector3d> adjacentPoints;
    for (const Trunk* trunk : trunks) {
        for (std::size_t n = 1; n < trunk->radiusMm.size(); ++n) {
            if (std::ranges::any_of(traced, [&](const Trunk* other) { return isAdjacent(*trunk, n, *other); })) {
                adjacentPoints.push_back(trunk->pointsInPatient[n]);
                candidate.adjacentMm += (adjacentPoints.back() - trunk->pointsInPatient[n - 1]).norm();
            }
        }
    }
    candidate.positionInPatient =
        adjacentPoints.empty() ? Eigen::Vector3d::Zero() : adjacentPoints[adjacentPoints.size() / 2];
    return candidate;
}

}   // namespace

AdjacentLumen possibleFalseLumen(const VoxelMask& lumen, const std::vector<GreatVessel>& greatVessels)
{
    std::vector<const Trunk*> traced;
    std::vector<std::vector<const Trunk*>> others;
    for (const GreatVessel& great : greatVessels) {
        others.emplace_back();
        for (const Trunk& trunk : great.trunks) {
            if (trunk.medianRadiusMm() >= minRadiusMm) {
                (containsTrunk(lumen, trunk) ? traced : others.back()).push_back(&trunk);
            }
        }
    }
    AdjacentLumen longest;
    for (const std::vector<const Trunk*>& other : others) {
        const AdjacentLumen candidate = measureAdjacency(other, traced);
        longest = candidate.adjacentMm > longest.adjacentMm ? candidate : longest;
    }
    return longest;
}

}   // namespace angiopose::core
