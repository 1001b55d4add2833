#include "core/tracing/volume/path/appearance_along_path.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>

using namespace angiopose;

namespace {

using namespace core;

/// A noise-free scan of a straight vessel along x through the middle, with surroundings given by `around`.
template <class Around>
Volume scanAround(double radiusMm, const Around& around)
{
    VolumeGeometry grid;
    grid.size = {60, 60, 60};
    grid.spacingMm = Eigen::Vector3d::Constant(0.8);
    Volume volume(grid);
    for (std::size_t n = 0; n < volume.voxels.size(); ++n) {
        const Eigen::Vector3d place =
            grid.voxelAt(n).cast<double>().cwiseProduct(grid.spacingMm) - Eigen::Vector3d::Constant(24.0);
        const double share = std::clamp(0.5 + (radiusMm - std::hypot(place.y(), place.z())) / 0.8, 0.0, 1.0);
        const double beside = around(place);
        volume.voxels[n] = static_cast<std::int16_t>(std::lround(beside + share * (500.0 - beside)));
    }
    return volume;
}

std::vector<Eigen::Vector3d> axis()
{
    std::vector<Eigen::Vector3d> points;
    for (double x = 4.0; x <= 44.0; x += 0.8) {
        points.emplace_back(x, 24.0, 24.0);
    }
    return points;
}

TEST(AppearanceAlongPath, FatBesideTheLungIsNotHalfFull)
{
    const Volume volume =
        scanAround(3.0, [](const Eigen::Vector3d& place) { return place.z() > 0.0 ? -800.0 : -80.0; });
    const TubeDetector detector(volume);
    const AppearanceAlongPath appearance(detector, axis());
    EXPECT_LT(appearance.opacification({24.0, 24.0, 17.0}), 0.45);
    EXPECT_GT(appearance.opacification({24.0, 24.0, 24.0}), 0.9);
}

TEST(AppearanceAlongPath, KnowsTissueInTheMiddleOfAWideVessel)
{
    // Narrow at first; within 6 mm of the axis, the rest contains only blood.
    const Volume volume = scanAround(2.0, [](const Eigen::Vector3d& place) {
        return place.x() > 0.0 && place.tail<2>().norm() < 12.0 ? 500.0 : 40.0;
    });
    const TubeDetector detector(volume);
    const AppearanceAlongPath appearance(detector, axis());
    EXPECT_GT(appearance.opacification({38.0, 24.0, 24.0}), 0.9);
    EXPECT_GT(appearance.opacification({38.0, 24.0, 33.0}), 0.9);
    EXPECT_LT(appearance.opacification({38.0, 24.0, 40.0}), 0.3);
}

TEST(AppearanceAlongPath, TheQuickFillIsTheSame)
{
    const Volume volume = scanAround(3.0, [](const Eigen::Vector3d& place) { return 60.0 + place.x(); });
    const TubeDetector detector(volume);
    const AppearanceAlongPath appearance(detector, axis());
    const PointOpacification quick = appearance.cachedOpacification();
    for (double x = 2.0; x < 46.0; x += 0.7) {
        for (const double y : {20.0, 23.5, 27.1}) {
            EXPECT_NEAR(quick({x, y, 24.0}), appearance.opacification({x, y, 24.0}), 0.01);
        }
    }
}

}   // namespace
