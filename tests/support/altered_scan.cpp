#include "tests/support/altered_scan.h"

#include "core/support/random.h"
#include "tests/support/axis_orders.h"
#include "tests/support/for_each.h"

#include <algorithm>
#include <cmath>

namespace angiopose::test {
namespace {

using core::Volume;
using core::VolumeGeometry;

constexpr std::uint64_t scanNoiseSeed = 11;
constexpr double softTissueHu = 60.0;

std::int16_t stored(double value)
{
    return static_cast<std::int16_t>(std::lround(std::clamp(value, -32768.0, 32767.0)));
}

template <class Map>
Volume mappedScan(Volume scan, const Map& map)
{
    for (std::int16_t& voxel : scan.voxels) {
        voxel = stored(map(static_cast<double>(voxel)));
    }
    return scan;
}

/// Linear interpolation between voxels, with border values extended outward.
double valueAt(const Volume& scan, const Eigen::Vector3d& voxel)
{
    const Eigen::Vector3d low = voxel.array().floor();
    double sum = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        const Eigen::Vector3i step(corner & 1, corner >> 1 & 1, corner >> 2);
        const Eigen::Vector3d share = (step.array() != 0).select((voxel - low).array(), 1.0 - (voxel - low).array());
        const Eigen::Vector3i at =
            (low.cast<int>() + step).cwiseMax(0).cwiseMin((scan.geometry.size.array() - 1).matrix());
        sum += share.prod() * scan.at(at.x(), at.y(), at.z());
    }
    return sum;
}

/// Resamples to another voxel size; larger voxels are means over their extent, as thick slices are.
Volume withSpacing(const Volume& scan, const Eigen::Vector3d& spacingMm)
{
    const Eigen::Vector3d ratio = spacingMm.cwiseQuotient(scan.geometry.spacingMm);
    VolumeGeometry geometry = scan.geometry;
    geometry.spacingMm = spacingMm;
    geometry.size = (scan.geometry.size.cast<double>().array() / ratio.array()).floor().cast<int>();
    geometry.originInPatient = scan.geometry.patientFromVoxel() * (0.5 * (ratio.array() - 1.0)).matrix();
    Volume result(geometry);
    const Eigen::Array3i samples = ratio.array().ceil().cast<int>();
    test::forEachVoxel(geometry.size, [&](int i, int j, int k) {
        double sum = 0.0;
        for (int n = 0; n < samples.prod(); ++n) {
            const Eigen::Array3d part(n % samples.x(), n / samples.x() % samples.y(), n / (samples.x() * samples.y()));
            const Eigen::Array3d in = Eigen::Array3d(i, j, k) + (part + 0.5) / samples.cast<double>();
            sum += valueAt(scan, (in * ratio.array() - 0.5).matrix());
        }
        result.at(i, j, k) = stored(sum / samples.prod());
    });
    return result;
}

/// Crops the voxels from `low` to below `high`, as shares of the size.
Volume croppedScan(const Volume& scan, const Eigen::Array3d& low, const Eigen::Array3d& high)
{
    const Eigen::Array3d size = scan.geometry.size.cast<double>().array();
    const Eigen::Vector3i first = (low * size).round().cast<int>();
    VolumeGeometry geometry = scan.geometry;
    geometry.size = (high * size).round().cast<int>().matrix() - first;
    geometry.originInPatient = scan.geometry.patientFromVoxel() * first.cast<double>();
    Volume part(geometry);
    test::forEachVoxel(geometry.size, [&](int i, int j, int k) {
        part.at(i, j, k) = scan.at(i + first.x(), j + first.y(), k + first.z());
    });
    return part;
}

Volume noisyScan(Volume scan, double sigmaHu)
{
    core::CounterRandom random(scanNoiseSeed);
    return mappedScan(std::move(scan), [&](double value) { return value + sigmaHu * random.normal(); });
}

/// Scales all values above soft tissue by `share` of their contrast.
Volume withContrast(const Volume& scan, double share)
{
    return mappedScan(
        scan, [share](double hu) { return hu > softTissueHu ? softTissueHu + share * (hu - softTissueHu) : hu; });
}

}   // namespace

std::vector<ScanChange> scanChanges()
{
    using V = const Volume&;
    return {
        {"as it is", [](V v) { return v; }},
        {"axes reversed",
         [](V v) {
             return stored(v, AxisOrder{{0, 1, 2}, {true, true, true}});
         }},
        {"axes exchanged",
         [](V v) {
             return stored(v, AxisOrder{{2, 0, 1}, {false, true, false}});
         }},
        {"slices of 2 mm",
         [](V v) {
             return withSpacing(v, {1.5, 1.5, 2.0});
         }},
        {"slices of 3 mm",
         [](V v) {
             return withSpacing(v, {1.5, 1.5, 3.0});
         }},
        {"slices of 5 mm",
         [](V v) {
             return withSpacing(v, {1.5, 1.5, 5.0});
         }},
        {"voxels of 1 mm",
         [](V v) {
             return withSpacing(v, {1.0, 1.0, 1.0});
         }},
        {"voxels of 0.75 mm",
         [](V v) {
             return withSpacing(v, {0.75, 0.75, 0.75});
         }},
        {"voxels of 2 mm",
         [](V v) {
             return withSpacing(v, {2.0, 2.0, 2.0});
         }},
        {"upper 3/4",
         [](V v) {
             return croppedScan(v, {0.0, 0.0, 0.25}, Eigen::Array3d::Ones());
         }},
        {"middle",
         [](V v) {
             return croppedScan(v, {0.1, 0.1, 0.1}, {0.9, 0.9, 0.9});
         }},
        {"values from 0 (+1024)",
         [](V v) { return mappedScan(v, [](double hu) { return std::max(0.0, hu + 1024.0); }); }},
        {"values +1000", [](V v) { return mappedScan(v, [](double hu) { return hu + 1000.0; }); }},
        {"in tenths, from 0",
         [](V v) { return mappedScan(v, [](double hu) { return std::max(0.0, 0.1 * (hu + 1024.0)); }); }},
        {"padding -3024", [](V v) { return mappedScan(v, [](double hu) { return hu < -1000.0 ? -3024.0 : hu; }); }},
        {"noise 20 HU", [](V v) { return noisyScan(v, 20.0); }},
        {"noise 40 HU", [](V v) { return noisyScan(v, 40.0); }},
        {"3/4 of the contrast", [](V v) { return withContrast(v, 0.75); }},
        {"half the contrast", [](V v) { return withContrast(v, 0.5); }},
        {"1.5 x the contrast", [](V v) { return withContrast(v, 1.5); }},
    };
}

}   // namespace angiopose::test
