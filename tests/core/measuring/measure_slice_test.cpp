#include "core/measuring/measure_image.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace angiopose::core;

namespace {

SliceMeasurement inSlice(MeasurementKind kind, BodyPlane plane, std::vector<Eigen::Vector3d> points)
{
    return {kind, plane, std::move(points), {}};
}

TEST(MeasureSlice, LengthsAnglesAndAreasAreThoseInThePatient)
{
    const auto length =
        valueOf(inSlice(MeasurementKind::Length, BodyPlane::Coronal, {{1, 7, 2}, {4, 7, 6}, {4, 7, -4}}));
    EXPECT_NEAR(length.value().value, 15.0, 1e-12);
    EXPECT_STREQ(length.value().unit, "mm");
    const auto angle = valueOf(inSlice(MeasurementKind::Angle, BodyPlane::Sagittal, {{3, 5, 0}, {3, 0, 0}, {3, 0, 2}}));
    EXPECT_NEAR(angle.value().value, 90.0, 1e-12);
    const auto area =
        valueOf(inSlice(MeasurementKind::Area, BodyPlane::Axial, {{0, 0, 9}, {6, 0, 9}, {6, 4, 9}, {0, 4, 9}}));
    EXPECT_NEAR(area.value().value, 24.0, 1e-12);
    EXPECT_STREQ(area.value().unit, "mm²");
}

TEST(MeasureSlice, WhatIsNoneHasAReason)
{
    EXPECT_FALSE(valueOf(inSlice(MeasurementKind::Angle, BodyPlane::Axial, {{0, 0, 0}, {1, 0, 0}})));
    EXPECT_FALSE(valueOf(
        inSlice(MeasurementKind::Area, BodyPlane::Axial, {{0, 0, 0}, {4, 4, 0}, {4, 0, 0}, {0, 4, 0}})));   // crossed
    EXPECT_FALSE(valueOf(inSlice(MeasurementKind::Length, BodyPlane::Axial, {{0, 0, 0}, {std::nan(""), 0, 0}})));
}

TEST(MeasureSlice, SaysWhichVoxelsItRestsOn)
{
    VolumeGeometry scan;
    scan.spacingMm = {0.4, 0.5, 3.0};
    const SliceMeasurement length = inSlice(MeasurementKind::Length, BodyPlane::Coronal, {{0, 7, 0}, {2, 7, 4}});
    ASSERT_EQ(basisOf(length, &scan).size(), 1U);
    EXPECT_EQ(basisOf(length, &scan)[0].text(), "Scan voxel size: 0.400 mm × 0.500 mm × 3.000 mm.");
    EXPECT_NE(basisOf(length, nullptr)[0].text().find("not open"), std::string::npos);
    EXPECT_NEAR(slicePositionMm(length), 7.0, 1e-12);
    EXPECT_LT((centerOf(length) - Eigen::Vector3d(1, 7, 2)).norm(), 1e-12);
}

}   // namespace
