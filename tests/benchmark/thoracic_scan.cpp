#include "tests/benchmark/thoracic_scan.h"

#include "core/support/random.h"
#include "core/tracing/volume/trace_vessels.h"
#include "io/volume_file.h"
#include "tests/support/test_data.h"

#include <algorithm>
#include <cstdio>

namespace angiopose::benchmarks {
namespace {

constexpr std::uint64_t placesSeed = 5;
constexpr int depthInAorta = 3;   ///< minimum distance from the wall, voxels
constexpr double endReachInRadii = 2.0;   ///< distance from the end of a mask's axis; the mask's own end is round

Eigen::Vector3i nearestVoxel(const core::VolumeGeometry& geometry, const Eigen::Vector3d& inPatient)
{
    return (geometry.patientFromVoxel().inverse() * inPatient).array().round().cast<int>();
}

/// The given arteries as labels 1, 2, …, with the aorta as 1.
core::LabelVolume givenArteries()
{
    core::LabelVolume all;
    std::uint16_t label = 0;
    for (const char* name : {"aorta", "brachiocephalic_trunk", "common_carotid_artery_left", "subclavian_artery_left",
                             "celiac_trunk", "superior_mesenteric_artery"}) {
        const core::Volume mask = readScan(std::string("thoracic-aorta-cta/") + name + ".nii.gz");
        if (all.voxels.empty()) {
            all = core::LabelVolume(mask.geometry);
        }
        ++label;
        for (std::size_t v = 0; v < mask.voxels.size(); ++v) {
            all.voxels[v] = mask.voxels[v] != 0 ? label : all.voxels[v];
        }
    }
    return all;
}

core::VoxelMask withLumens(const core::LabelVolume& arteries)
{
    core::VoxelMask all(arteries.geometry);
    const core::Volume lumens = readScan("thoracic-aorta-cta/T716_aorta_true_false_lumen.nii.gz");
    for (std::size_t v = 0; v < lumens.voxels.size(); ++v) {
        all.voxels[v] = arteries.voxels[v] != 0 || lumens.voxels[v] != 0 ? 1 : 0;
    }
    return all;
}

}   // namespace

core::Volume readScan(const std::string& relative)
{
    auto read = io::readVolume(test::dataFile(relative).string());
    if (!read) {
        std::printf("%s\n", read.error().message.text().c_str());
        return {};
    }
    return std::move(read).value().volume;
}

Eigen::Vector3d ThoracicScan::at(int i, int j, int k) const
{
    return scan.geometry.patientFromVoxel() * Eigen::Vector3d(i, j, k);
}

bool ThoracicScan::isArtery(const Eigen::Vector3d& inPatient) const
{
    const Eigen::Vector3i voxel = nearestVoxel(arteries.geometry, inPatient);
    return arteries.geometry.contains(voxel) && arteries.at(voxel.x(), voxel.y(), voxel.z()) != 0;
}

bool ThoracicScan::isLumen(const Eigen::Vector3d& inPatient) const
{
    const Eigen::Vector3i voxel = nearestVoxel(lumens.geometry, inPatient);
    return lumens.geometry.contains(voxel) && lumens.at(voxel.x(), voxel.y(), voxel.z()) != 0;
}

bool ThoracicScan::isAtAnEnd(const Eigen::Vector3d& inPatient) const
{
    for (const core::VesselBranch& branch : axes.branches) {
        const bool isEnd =
            (branch.pointsInPatient.back() - inPatient).norm() <= endReachInRadii * branch.radiusMm.back();
        const bool isRoot = branch.generation == 0 && (branch.pointsInPatient.front() - inPatient).norm() <=
                                                          endReachInRadii * branch.radiusMm.front();
        if (isEnd || isRoot) {
            return true;
        }
    }
    return false;
}

double ThoracicScan::value(const Eigen::Vector3d& inPatient) const
{
    const Eigen::Vector3i at =
        nearestVoxel(scan.geometry, inPatient).cwiseMax(0).cwiseMin((scan.geometry.size.array() - 1).matrix());
    return scan.value(scan.geometry.index(at.x(), at.y(), at.z()));
}

double ThoracicScan::mmToArteries(const Eigen::Vector3d& inPatient) const
{
    const core::VolumeGeometry& grid = toArteries.geometry;
    const Eigen::Vector3i at = nearestVoxel(grid, inPatient).cwiseMax(0).cwiseMin((grid.size.array() - 1).matrix());
    return toArteries.mm(grid.index(at.x(), at.y(), at.z()));
}

std::optional<ThoracicScan> readThoracicScan()
{
    ThoracicScan thorax{readScan("thoracic-aorta-cta/ct_cropped.nii.gz"), givenArteries(), {}, {}, {}};
    thorax.lumens = withLumens(thorax.arteries);
    core::VoxelMask others(thorax.arteries.geometry);
    std::transform(thorax.arteries.voxels.begin(), thorax.arteries.voxels.end(), others.voxels.begin(),
                   [](std::uint16_t label) { return static_cast<std::uint8_t>(label == 0 ? 1 : 0); });
    core::TracingProgress unheard({});
    thorax.toArteries = core::distanceMap(others, 1, unheard);
    // The masks come from a neural network and have stubs on their walls that are not vessels.
    auto axes =
        core::traceLabels(thorax.arteries, {}, {.minBranchLengthMm = 12.0, .pieces = core::TracedPieces::Largest});
    if (thorax.scan.voxels.empty() || !axes) {
        return std::nullopt;
    }
    thorax.axes = std::move(axes).value().tree;
    return thorax;
}

Eigen::Vector3d seedOf(const ThoracicScan& thorax)
{
    return thorax.at(51, 48, 107);
}

Eigen::Vector3d rootOf(const ThoracicScan& thorax)
{
    return thorax.at(52, 48, 85);
}

std::vector<Eigen::Vector3d> placesInAorta(const ThoracicScan& thorax, int count)
{
    core::CounterRandom random(placesSeed);
    const Eigen::Vector3i& size = thorax.arteries.geometry.size;
    const auto isAorta = [&](const Eigen::Vector3i& voxel) {
        return thorax.arteries.geometry.contains(voxel) && thorax.arteries.at(voxel.x(), voxel.y(), voxel.z()) == 1;
    };
    std::vector<Eigen::Vector3d> places;
    while (static_cast<int>(places.size()) < count) {
        const Eigen::Vector3i voxel(random.index(size.x()), random.index(size.y()), random.index(size.z()));
        bool isDeep = isAorta(voxel);
        for (int axis = 0; axis < 3; ++axis) {
            const Eigen::Vector3i step = depthInAorta * Eigen::Vector3i::Unit(axis);
            isDeep = isDeep && isAorta(voxel + step) && isAorta(voxel - step);
        }
        if (isDeep) {
            places.push_back(thorax.at(voxel.x(), voxel.y(), voxel.z()));
        }
    }
    return places;
}

}   // namespace angiopose::benchmarks
