#include "core/registration/picture/drr.h"
#include "tests/support/for_each.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace angiopose::core {
namespace {

/// Air around a block of water that contains an off-center rod of bone along z.
Volume rodInWater()
{
    VolumeGeometry geometry;
    geometry.size = {60, 60, 60};
    geometry.spacingMm.setConstant(2.0);
    geometry.originInPatient.setConstant(-59.0);
    Volume scan(geometry, -1000);
    test::forEachVoxel({10, 10, 5}, {50, 50, 55}, [&](int i, int j, int k) {
        scan.at(i, j, k) = std::abs(i - 40) < 2 && std::abs(j - 20) < 2 ? 1500 : 0;
    });
    return scan;
}

/// The DRR is brightest where the camera projects the bone.
TEST(BodyDrr, ShowsBoneWhereTheCameraSeesIt)
{
    const Volume scan = rodInWater();
    const ProjectionCamera camera{2000.0, 2000.0, 255.5, 255.5, 512, 512};
    RigidTransform cameraFromPatient;
    cameraFromPatient.rotation << 1, 0, 0, 0, 0, -1, 0, 1, 0;   // frontal view, head up
    cameraFromPatient.translation.z() = 750.0;
    const BodyDrr body(scan, camera, 256);
    const ImageF picture = body.from(cameraFromPatient);
    ASSERT_EQ(picture.width, 256);
    const Eigen::Vector3d rod = scan.geometry.patientFromVoxel() * Eigen::Vector3d(40, 20, 30);
    const auto expected = project(camera, cameraFromPatient * rod);
    ASSERT_TRUE(expected);
    const float* row = &picture.at(0, static_cast<int>(expected->y() / 2.0));
    const auto brightest = std::max_element(row, row + picture.width) - row;
    EXPECT_NEAR(static_cast<double>(brightest), expected->x() / 2.0, 3.0);
    EXPECT_EQ(picture.at(5, 5), 0.0F);
}

}   // namespace
}   // namespace angiopose::core
