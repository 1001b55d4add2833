#include "core/tracing/volume/voxels/component_selection.h"

#include "core/messages/messages.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

namespace angiopose::core {
namespace {

constexpr double seedReachMm = 3.0;
constexpr double farSeedReachMm = 10.0;   ///< maximum to the core of a wide vessel (two voxels inside its wall)

/// Returns the nearest voxel of at least `minValue` within `reachMm`.
std::optional<std::uint32_t> nearestVoxel(const VoxelMask& mask, const Eigen::Vector3d& positionInPatient,
                                          double reachMm, std::uint8_t minValue)
{
    const VolumeGeometry& grid = mask.geometry;
    const Eigen::Vector3d place = grid.patientFromVoxel().inverse() * positionInPatient;
    const Eigen::Array3d reach = reachMm / grid.spacingMm.array() + 1.0;
    const Eigen::Vector3i low = (place.array() - reach).floor().max(0.0).cast<int>();
    const Eigen::Vector3i high = (place.array() + reach).ceil().min(grid.size.cast<double>().array() - 1.0).cast<int>();
    std::optional<std::uint32_t> nearest;
    double nearestMm = reachMm;
    for (int k = low.z(); k <= high.z(); ++k) {
        for (int j = low.y(); j <= high.y(); ++j) {
            for (int i = low.x(); i <= high.x(); ++i) {
                const double distanceMm = grid.spacingMm.cwiseProduct(Eigen::Vector3d(i, j, k) - place).norm();
                if (mask.at(i, j, k) >= minValue && distanceMm <= nearestMm) {
                    nearestMm = distanceMm;
                    nearest = static_cast<std::uint32_t>(grid.index(i, j, k));
                }
            }
        }
    }
    return nearest;
}

Error noVesselAt(const Eigen::Vector3d& seed)
{
    return messages::seedOutsideVessel(formatPoint(seed));
}

Result<std::set<std::size_t>> componentsWithSeeds(const VoxelMask& mask, const std::vector<VoxelComponent>& components,
                                                  const std::vector<Eigen::Vector3d>& seedsInPatient)
{
    std::set<std::size_t> chosen;
    for (const Eigen::Vector3d& seed : seedsInPatient) {
        const std::optional<std::uint32_t> voxel = findVoxelNear(mask, seed);
        if (!voxel) {
            return noVesselAt(seed);
        }
        for (std::size_t p = 0; p < components.size(); ++p) {
            if (std::binary_search(components[p].begin(), components[p].end(), *voxel)) {
                chosen.insert(p);
            }
        }
    }
    return chosen;
}

std::size_t largestComponent(const VoxelMask& mask, const std::vector<VoxelComponent>& components)
{
    std::size_t best = 0;
    std::ptrdiff_t maxCore = -1;
    for (std::size_t p = 0; p < components.size(); ++p) {
        const auto inCore = std::count_if(components[p].begin(), components[p].end(),
                                          [&](std::uint32_t voxel) { return mask.voxels[voxel] > 1; });
        if (inCore > maxCore) {
            maxCore = inCore;
            best = p;
        }
    }
    return best;
}

/// Sets the chosen components to 1 and everything else to 0.
void keepOnly(VoxelMask& mask, const std::vector<VoxelComponent>& components, const std::set<std::size_t>& chosen)
{
    std::fill(mask.voxels.begin(), mask.voxels.end(), std::uint8_t{0});
    for (const std::size_t p : chosen) {
        for (const std::uint32_t voxel : components[p]) {
            mask.voxels[voxel] = 1;
        }
    }
}

Result<std::set<std::size_t>> chooseComponents(const VoxelMask& mask, const std::vector<VoxelComponent>& components,
                                               const std::vector<Eigen::Vector3d>& seedsInPatient,
                                               TracedPieces withoutSeeds)
{
    if (!seedsInPatient.empty()) {
        return componentsWithSeeds(mask, components, seedsInPatient);
    }
    if (withoutSeeds != TracedPieces::All) {
        return std::set<std::size_t>{largestComponent(mask, components)};
    }
    std::set<std::size_t> all;
    for (std::size_t p = 0; p < components.size(); ++p) {
        all.insert(all.end(), p);
    }
    return all;
}

}   // namespace

Message formatPoint(const Eigen::Vector3d& point)
{
    const auto tenth = [](double value) { return Quantity{std::round(10.0 * value) / 10.0 + 0.0, 1}; };   // avoids -0.0
    return messages::place(tenth(point.x()), tenth(point.y()), tenth(point.z()));
}

std::optional<std::uint32_t> findVoxelNear(const VoxelMask& mask, const Eigen::Vector3d& seedInPatient)
{
    return nearestVoxel(mask, seedInPatient, std::max(seedReachMm, mask.geometry.spacingMm.maxCoeff()), 1);
}

Result<SeedsInLumen> moveSeedsIntoLumen(const VoxelMask& mask, const std::vector<Eigen::Vector3d>& seedsInPatient)
{
    SeedsInLumen seeds;
    for (const Eigen::Vector3d& seed : seedsInPatient) {
        if (findVoxelNear(mask, seed)) {
            seeds.seedPoints.push_back(seed);
            continue;
        }
        const auto voxel = nearestVoxel(mask, seed, farSeedReachMm, 2);
        if (!voxel) {
            return noVesselAt(seed);
        }
        seeds.seedPoints.emplace_back(mask.geometry.patientFromVoxel() * mask.geometry.voxelAt(*voxel).cast<double>());
        seeds.warnings.push_back(
            messages::seedMoved(formatPoint(seed), inMm((seeds.seedPoints.back() - seed).norm(), 1)));
    }
    return seeds;
}

Result<std::vector<TracedComponent>> selectComponents(VoxelMask& mask,
                                                      const std::vector<Eigen::Vector3d>& seedsInPatient,
                                                      TracedPieces withoutSeeds, TracingProgress& progress)
{
    const std::vector<VoxelComponent> components = connectedComponents(mask, 1, &progress);
    if (progress.isStopped()) {
        return tracingCanceled();
    }
    if (components.empty()) {
        return Error(messages::noVesselInVolume());
    }
    auto chosen = chooseComponents(mask, components, seedsInPatient, withoutSeeds);
    if (!chosen) {
        return chosen.error();
    }
    keepOnly(mask, components, chosen.value());
    std::vector<TracedComponent> excluded;
    for (std::size_t p = 0; p < components.size(); ++p) {
        if (!chosen.value().contains(p)) {
            excluded.push_back(describeComponent(components[p], mask.geometry));
        }
    }
    return excluded;
}

TracedComponent describeComponent(const VoxelComponent& voxels, const VolumeGeometry& grid)
{
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const std::uint32_t voxel : voxels) {
        middle += grid.voxelAt(voxel).cast<double>() / static_cast<double>(voxels.size());
    }
    Eigen::Vector3d place = Eigen::Vector3d::Zero();
    double nearestSquared = std::numeric_limits<double>::max();
    for (const std::uint32_t voxel : voxels) {
        const Eigen::Vector3d at = grid.voxelAt(voxel).cast<double>();
        const double squared = grid.spacingMm.cwiseProduct(at - middle).squaredNorm();
        if (squared < nearestSquared) {
            nearestSquared = squared;
            place = at;
        }
    }
    TracedComponent piece;
    piece.voxels = voxels.size();
    piece.positionInPatient = grid.patientFromVoxel() * place;
    return piece;
}

Cancellation tracingCanceled()
{
    return {messages::tracingStopped()};
}

}   // namespace angiopose::core
