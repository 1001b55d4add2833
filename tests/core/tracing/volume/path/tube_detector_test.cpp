#include "core/tracing/volume/path/tube_detector.h"

#include "core/support/random.h"

#include <gtest/gtest.h>

using namespace angiopose;

namespace {

using namespace core;

TEST(TubeDetector, FindsTheSameShareSooner)
{
    VolumeGeometry grid;
    grid.size = {30, 30, 30};
    grid.spacingMm = {0.8, 0.8, 1.0};
    Volume volume(grid);
    CounterRandom random(9);
    for (std::size_t n = 0; n < volume.voxels.size(); ++n) {
        const Eigen::Vector3i at = grid.voxelAt(n);
        const double away = std::hypot(at.x() - 14.0, at.y() - 15.0);
        volume.voxels[n] = static_cast<std::int16_t>((away < 3.0 ? 300.0 : 50.0) + 40.0 * random.normal());
    }
    const TubeDetector detector(volume);
    double sum = 0.0;
    for (std::size_t n = 0; n < volume.voxels.size(); n += 7) {   // including voxels at the border
        const double fraction = detector.tube(grid.voxelAt(n), 50.0).fraction;
        EXPECT_EQ(detector.tubeResemblance(grid.voxelAt(n), 50.0), fraction);
        sum += fraction;
    }
    EXPECT_GT(sum, 10.0);
}

}   // namespace
