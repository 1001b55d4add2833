#include "core/imaging/volume_slice.h"

#include "tests/support/axis_orders.h"
#include "tests/support/for_each.h"

#include <gtest/gtest.h>
#include <cmath>

namespace angiopose::core {
namespace {

/// A volume whose values encode the voxel positions in the patient: 100 z + 10 y + x, spacing 1 × 2 × 3 mm.
Volume placedVolume()
{
    VolumeGeometry geometry;
    geometry.size = {5, 4, 3};
    geometry.spacingMm = {1.0, 2.0, 3.0};
    geometry.originInPatient = {-10.0, 20.0, 500.0};
    Volume volume(geometry);
    test::forEachVoxel(
        {5, 4, 3}, [&](int i, int j, int k) { volume.at(i, j, k) = static_cast<std::int16_t>(100 * k + 10 * j + i); });
    return volume;
}

float pixel(const SliceGrid& grid, const std::vector<float>& values, int column, int row)
{
    return values[static_cast<std::size_t>(row * grid.width + column)];
}

TEST(VolumeSlice, LooksFromTheFeetTheFrontAndTheLeft)
{
    const Volume volume = placedVolume();
    const Eigen::Vector3d point(-8.2, 23.0, 503.4);   // nearest voxel 2, 1 or 2, 1

    const SliceGrid axial = sliceThrough(volume.geometry, BodyPlane::Axial, point);
    ASSERT_EQ(axial.width, 5);
    ASSERT_EQ(axial.height, 4);
    const auto fromFeet = sliceValues(volume, axial);
    EXPECT_EQ(pixel(axial, fromFeet, 0, 0), 100.0F);   // the patient's right front corner is at the top left
    EXPECT_EQ(pixel(axial, fromFeet, 4, 0), 104.0F);   // the patient's left is on the right
    EXPECT_EQ(pixel(axial, fromFeet, 0, 3), 130.0F);   // posterior is at the bottom

    const SliceGrid coronal = sliceThrough(volume.geometry, BodyPlane::Coronal, {-8.2, 21.9, 503.4});
    ASSERT_EQ(coronal.width, 5);
    ASSERT_EQ(coronal.height, 3);
    const auto fromFront = sliceValues(volume, coronal);
    EXPECT_EQ(pixel(coronal, fromFront, 0, 0), 210.0F);   // the head is at the top
    EXPECT_EQ(pixel(coronal, fromFront, 4, 2), 14.0F);

    const SliceGrid sagittal = sliceThrough(volume.geometry, BodyPlane::Sagittal, point);
    ASSERT_EQ(sagittal.width, 4);
    ASSERT_EQ(sagittal.height, 3);
    const auto fromLeft = sliceValues(volume, sagittal);
    EXPECT_EQ(pixel(sagittal, fromLeft, 0, 0), 202.0F);   // anterior is on the left
    EXPECT_EQ(pixel(sagittal, fromLeft, 3, 2), 32.0F);
}

TEST(VolumeSlice, IsTheSameForEveryStoredAxisOrder)
{
    const Volume original = placedVolume();
    VoxelMask mask(original.geometry);
    mask.at(3, 1, 2) = 7;
    const Eigen::Vector3d point(-7.0, 22.0, 506.0);
    for (const test::AxisOrder& order : test::allAxisOrders()) {
        const Volume volume = test::stored(original, order);
        const VoxelMask storedMask = test::stored(mask, order);
        for (const BodyPlane plane : bodyPlanes) {
            const SliceGrid grid = sliceThrough(volume.geometry, plane, point);
            const SliceGrid expected = sliceThrough(original.geometry, plane, point);
            EXPECT_LT((grid.firstInPatient - expected.firstInPatient).norm(), 1e-9);
            ASSERT_EQ(sliceValues(volume, grid), sliceValues(original, expected));
            ASSERT_EQ(sliceMask(storedMask, grid), sliceMask(mask, expected));
            EXPECT_EQ(sliceIndex(volume.geometry, plane, point), sliceIndex(original.geometry, plane, point));
        }
    }
}

TEST(VolumeSlice, PixelsAndPointsAreInverse)
{
    const SliceGrid grid = sliceThrough(placedVolume().geometry, BodyPlane::Coronal, {-8.0, 24.0, 503.0});
    const Eigen::Vector3d point = grid.pointAt({1.25, 0.5});
    EXPECT_LT((grid.pixelOf(point) - Eigen::Vector2d(1.25, 0.5)).norm(), 1e-12);
    EXPECT_NEAR(grid.distanceMm(point + Eigen::Vector3d(0, 1.5, 0)), 1.5, 1e-12);
    EXPECT_EQ(sliceCount(placedVolume().geometry, BodyPlane::Coronal), 4);
}

TEST(VolumeSlice, CutsAnObliqueVolumeAlongThePatient)
{
    Volume volume = test::countedVolume({12, 12, 12});
    const auto ramp = [](const Eigen::Vector3d& point) { return 3.0 * point.x() - 2.0 * point.y() + point.z(); };
    test::forEachVoxel({12, 12, 12}, [&](int i, int j, int k) {
        volume.at(i, j, k) = static_cast<std::int16_t>(
            std::lround(10.0 * ramp(volume.geometry.patientFromVoxel() * Eigen::Vector3d(i, j, k))));
    });
    volume.slope = 0.1;
    for (const BodyPlane plane : bodyPlanes) {
        const SliceGrid grid = sliceThrough(volume.geometry, plane, centerOf(volume.geometry));
        EXPECT_NEAR(grid.columnStep.norm(), 0.5, 1e-12);
        const auto values = sliceValues(volume, grid);
        int inside = 0;
        for (int row = 0; row < grid.height; ++row) {
            for (int column = 0; column < grid.width; ++column) {
                const float value = pixel(grid, values, column, row);
                if (std::isnan(value)) {
                    continue;
                }
                ++inside;
                // Up to half a voxel beyond the outermost centers, the border value is extended.
                EXPECT_NEAR(value, ramp(grid.pointAt({column, row})), 3.0);
            }
        }
        EXPECT_GT(inside, grid.width * grid.height / 3);
        EXPECT_LT(inside, grid.width * grid.height);   // the corners are outside
        EXPECT_NEAR(pixel(grid, values, grid.width / 2, grid.height / 2),
                    ramp(grid.pointAt({grid.width / 2, grid.height / 2})), 0.11);
    }
}

TEST(VolumeSlice, KnowsTheValueAtAPoint)
{
    const Volume volume = placedVolume();
    EXPECT_EQ(valueAt(volume, {-7.0, 22.2, 506.4}), 213.0);
    EXPECT_FALSE(valueAt(volume, {-7.0, 22.2, 512.0}));
    EXPECT_EQ(clampToVolume(volume.geometry, {-7.0, 90.0, 512.0}), Eigen::Vector3d(-7.0, 26.0, 506.0));
}

}   // namespace
}   // namespace angiopose::core
