#include "core/imaging/compact_labels.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <numeric>

namespace angiopose::core {
namespace {

VolumeGeometry geometryOf(int columns, int rows, int slices)
{
    VolumeGeometry geometry;
    geometry.size = {columns, rows, slices};
    geometry.spacingMm = {1.0, 2.0, 3.0};
    geometry.originInPatient = {-5.0, 7.0, 100.0};
    return geometry;
}

TEST(CompactLabels, NumberLabelsByTheirPlaceInTheList)
{
    LabelVolume image(geometryOf(4, 1, 1));
    image.voxels = {0, 900, 3, 17};
    const CompactLabels numbered = compactLabels(image, {3, 900});
    EXPECT_EQ(numbered.rows.voxels, (std::vector<std::uint8_t>{0, 2, 1, 0}));
    EXPECT_EQ(numbered.rows.geometry.originInPatient, image.geometry.originInPatient);
}

TEST(CompactLabels, TheMiddleLiesInTheLabel)
{
    LabelVolume image(geometryOf(9, 9, 3));
    for (int i = 0; i < 9; ++i) {   // a U shape, open on the right
        for (int j = 0; j < 9; ++j) {
            image.at(i, j, 1) = i == 0 || j == 0 || j == 8 ? 5 : 0;
        }
    }
    image.at(4, 4, 0) = 6;
    const CompactLabels numbered = compactLabels(image, {5, 6});
    ASSERT_EQ(numbered.centersInPatient.size(), 2U);
    const Eigen::Vector3d voxel = image.geometry.patientFromVoxel().inverse() * numbered.centersInPatient[0];
    const Eigen::Vector3i at = (voxel.array() + 0.5).floor().cast<int>();
    EXPECT_EQ(image.at(at.x(), at.y(), at.z()), 5);
    EXPECT_EQ(numbered.centersInPatient[1], Eigen::Vector3d(-1.0, 15.0, 100.0));
}

TEST(CompactLabels, ManyLabelsShareTheLastNumber)
{
    LabelVolume image(geometryOf(300, 1, 1));
    std::iota(image.voxels.begin(), image.voxels.end(), std::uint16_t{1});
    std::vector<int> labels(300);
    std::iota(labels.begin(), labels.end(), 1);
    const CompactLabels numbered = compactLabels(image, labels);
    EXPECT_EQ(numbered.rows.voxels[253], 254);
    EXPECT_EQ(std::count(numbered.rows.voxels.begin(), numbered.rows.voxels.end(), 255), 46);
    EXPECT_EQ(numbered.centersInPatient.size(), 300U);
}

}   // namespace
}   // namespace angiopose::core
