#include "tests/benchmark/thoracic_scan.h"

#include "core/support/random.h"
#include "core/tracing/volume/trace_vessels.h"
#include "io/volume_file.h"
#include "tests/support/test_data.h"

#include <algorithm>
#include <cstdio>

namespace benchmarks {
namespace {

constexpr double sampleMm = 0.5;
constexpr std::uint64_t placesSeed = 5;
constexpr int depthInAorta = 3;   ///< voxels to its wall
constexpr double axisReachMm = 2.0;   ///< along an axis
constexpr double arterialTolerance = 0.1;   ///< of the masked arteries' value

Eigen::Vector3i nearestVoxel(const core::VolumeGeometry& geometry, const Eigen::Vector3d& inPatient)
{
    return (geometry.patientFromVoxel().inverse() * inPatient).array().round().cast<int>();
}

/// The given arteries as labels 1, 2, …; the aorta is 1.
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

double medianOf(std::vector<double> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return values.empty() ? 0.0 : *middle;
}

OutsideRun runOf(const core::VesselBranch& branch, std::size_t first, std::size_t last, const ThoracicScan& thorax)
{
    std::vector<double> values;
    double farthestMm = 0.0;
    for (std::size_t i = first; i < last; ++i) {
        values.push_back(thorax.value(branch.pointsInPatient[i]));
        farthestMm = std::max(farthestMm, thorax.mmToArteries(branch.pointsInPatient[i]));
    }
    const auto radii = branch.radiusMm.begin();
    return {branch.id,
            sampleMm * static_cast<double>(last - first),
            medianOf({radii + static_cast<std::ptrdiff_t>(first), radii + static_cast<std::ptrdiff_t>(last)}),
            medianOf(values),
            branch.pointsInPatient[first],
            branch.pointsInPatient[last - 1],
            farthestMm,
            false};
}

/// The axis of an aorta with two lumens lies between them, so that a distance to it would say nothing: what counts is
/// whether a curve runs beside it.
double coveredShare(const std::vector<Eigen::Vector3d>& axis, const std::vector<Eigen::Vector3d>& insidePoints)
{
    std::vector<bool> isBeside(axis.size(), false);
    for (const Eigen::Vector3d& point : insidePoints) {
        const auto nearest = std::min_element(axis.begin(), axis.end(), [&](const auto& a, const auto& b) {
            return (a - point).squaredNorm() < (b - point).squaredNorm();
        });
        isBeside[static_cast<std::size_t>(nearest - axis.begin())] = true;
    }
    std::size_t covered = 0;
    for (const Eigen::Vector3d& point : axis) {
        for (std::size_t n = 0; n < axis.size(); ++n) {
            if (isBeside[n] && (axis[n] - point).norm() <= axisReachMm) {
                ++covered;
                break;
            }
        }
    }
    return static_cast<double>(covered) / std::max(1.0, static_cast<double>(axis.size()));
}

std::vector<Eigen::Vector3d> axisWithin(const core::VesselTree& axes, const core::VolumeGeometry* seen)
{
    std::vector<Eigen::Vector3d> axis;
    for (const core::VesselBranch& branch : core::resampled(axes, sampleMm).branches) {
        std::copy_if(branch.pointsInPatient.begin(), branch.pointsInPatient.end(), std::back_inserter(axis),
                     [&](const Eigen::Vector3d& point) {
                         return seen == nullptr || seen->contains(nearestVoxel(*seen, point));
                     });
    }
    return axis;
}

}   // namespace

core::Volume readScan(const std::string& relative)
{
    auto read = io::readVolume(test::dataFile(relative).string());
    if (!read) {
        std::printf("%s\n", read.error().message.c_str());
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
    ThoracicScan thorax{readScan("thoracic-aorta-cta/ct_cropped.nii.gz"), givenArteries(), {}, {}};
    core::VoxelMask others(thorax.arteries.geometry);
    std::transform(thorax.arteries.voxels.begin(), thorax.arteries.voxels.end(), others.voxels.begin(),
                   [](std::uint16_t label) { return static_cast<std::uint8_t>(label == 0 ? 1 : 0); });
    core::TracingProgress unheard({});
    thorax.toArteries = core::distanceMap(others, 1, unheard);
    // The masks are a network's, with stubs on their walls that are no vessels.
    auto axes = core::traceLabels(thorax.arteries, {}, {.minBranchLengthMm = 12.0});
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

Course courseOf(const core::VesselTree& tree, const ThoracicScan& thorax, const core::VolumeGeometry* seen)
{
    Course course;
    std::vector<Eigen::Vector3d> insidePoints;
    std::vector<double> insideValues;
    for (const core::VesselBranch& branch : core::resampled(tree, sampleMm).branches) {
        const auto& way = branch.pointsInPatient;
        for (std::size_t i = 0; i < way.size();) {
            const std::size_t first = i;
            const bool isIn = thorax.isArtery(way[i]);
            while (i < way.size() && thorax.isArtery(way[i]) == isIn) {
                ++i;
            }
            if (!isIn) {
                course.outside.push_back(runOf(branch, first, i, thorax));
                continue;
            }
            for (std::size_t n = first; n < i; ++n) {
                insidePoints.push_back(way[n]);
                insideValues.push_back(thorax.value(way[n]));
            }
        }
    }
    const double arteryValue = medianOf(insideValues);
    const double insideMm = sampleMm * static_cast<double>(insidePoints.size());
    double arterialMm = 0.0;
    double otherMm = 0.0;
    for (OutsideRun& run : course.outside) {
        run.isArterial = std::abs(run.value - arteryValue) <= arterialTolerance * arteryValue;
        (run.isArterial ? arterialMm : otherMm) += run.lengthMm;
    }
    course.lengthMm = insideMm + arterialMm + otherMm;
    const double all = std::max(course.lengthMm, sampleMm);
    course.inside = insideMm / all;
    course.outsideArterial = arterialMm / all;
    course.outsideOther = otherMm / all;
    course.covered = coveredShare(axisWithin(thorax.axes, seen), insidePoints);
    return course;
}

}   // namespace benchmarks
