#include "core/imaging/mask_brush.h"
#include "core/imaging/mask_cut.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numbers>

using namespace angiopose::core;

namespace {

VolumeGeometry unequalVoxels()
{
    VolumeGeometry geometry;
    geometry.size = {40, 30, 20};
    geometry.spacingMm = {0.5, 1.0, 2.0};
    geometry.direction << -1, 0, 0, 0, 1, 0, 0, 0, 1;   // mirrored x axis
    geometry.originInPatient = {10.0, -15.0, -20.0};
    return geometry;
}

VoxelMask whole()
{
    return VoxelMask(unequalVoxels(), 1);
}

std::size_t setVoxels(const VoxelMask& mask)
{
    return static_cast<std::size_t>(std::ranges::count(mask.voxels, 1));
}

TEST(MaskEdit, AChangeTakesItselfBackAndIsSmall)
{
    VoxelMask mask = whole();
    const VoxelMask before = mask;
    const MaskChange change = makeMaskChange({7, 5, 6, 5, 100});
    ASSERT_EQ(change.runs.size(), 2U);
    EXPECT_EQ(change.runs[0], (MaskChange::Run{5, 3}));
    EXPECT_EQ(change.voxelCount(), 4U);
    flip(mask, change);
    EXPECT_EQ(setVoxels(mask), before.voxels.size() - 4);
    flip(mask, change);
    EXPECT_EQ(mask.voxels, before.voxels);
}

TEST(MaskEdit, ABallHasItsVolumeInUnequalVoxels)
{
    VoxelMask mask(unequalVoxels());
    const Eigen::Vector3d center = centerOf(mask.geometry);
    const auto found = brushVolume(mask, {BrushMode::Paint, 6.0}, {center, center});
    flip(mask, makeMaskChange(found));
    const double mm3 = static_cast<double>(setVoxels(mask)) * mask.geometry.spacingMm.prod();
    EXPECT_NEAR(mm3, 4.0 / 3.0 * std::numbers::pi * 216.0, 0.04 * 905.0);
    EXPECT_TRUE(brushVolume(mask, {BrushMode::Paint, 6.0}, {center, center}).empty()) << "it is as wanted";
    flip(mask, makeMaskChange(brushVolume(mask, {BrushMode::Erase, 6.0}, {center, center})));
    EXPECT_EQ(setVoxels(mask), 0U);
}

TEST(MaskEdit, ADiscStaysInItsSliceAlongItsPath)
{
    VoxelMask mask(unequalVoxels());
    const SliceGrid slice = sliceThrough(mask.geometry, BodyPlane::Coronal, {0, 3, 0});
    const BrushStep step{{-4, 3, 0}, {4, 3, 0}};
    flip(mask, makeMaskChange(brushSlice(mask, slice, {BrushMode::Paint, 3.0}, step)));
    const double mm2 = static_cast<double>(setVoxels(mask)) * 0.5 * 2.0;
    EXPECT_NEAR(mm2, 8.0 * 6.0 + std::numbers::pi * 9.0, 8.0);
    for (std::size_t place = 0; place < mask.voxels.size(); ++place) {
        if (mask.voxels[place] != 0) {
            const Eigen::Vector3d at = mask.geometry.patientFromVoxel() * mask.geometry.voxelAt(place).cast<double>();
            EXPECT_NEAR(at.y(), slice.firstInPatient.y(), 1e-9);
        }
    }
    const auto box = boxOf(mask.geometry, makeMaskChange([&] {
                               VoxelIndices all;
                               for (std::size_t place = 0; place < mask.voxels.size(); ++place) {
                                   if (mask.voxels[place] != 0) {
                                       all.push_back(static_cast<std::uint32_t>(place));
                                   }
                               }
                               return all;
                           }()));
    EXPECT_NEAR(box.lowInPatient.y(), slice.firstInPatient.y() - 0.5, 1e-9);
    EXPECT_NEAR(box.highInPatient.y(), slice.firstInPatient.y() + 0.5, 1e-9);
    EXPECT_NEAR(box.lowInPatient.x(), -7.25, 0.51);
}

/// Number of voxels within the radius of a brush step, tested one by one.
std::size_t withinStep(const VoxelMask& mask, double radiusMm, const BrushStep& step)
{
    std::size_t count = 0;
    for (std::size_t place = 0; place < mask.voxels.size(); ++place) {
        const Eigen::Vector3d at = mask.geometry.patientFromVoxel() * mask.geometry.voxelAt(place).cast<double>();
        const Eigen::Vector3d way = step.toInPatient - step.fromInPatient;
        const double share =
            way.squaredNorm() > 0 ? std::clamp((at - step.fromInPatient).dot(way) / way.squaredNorm(), 0.0, 1.0) : 0.0;
        count += (at - step.fromInPatient - share * way).norm() <= radiusMm ? 1 : 0;
    }
    return count;
}

TEST(MaskEdit, ABallOnItsWayTakesAllThatLiesWithinItsRadius)
{
    VoxelMask mask(unequalVoxels());
    mask.geometry.direction = Eigen::AngleAxisd(0.4, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    const Eigen::Vector3d center = centerOf(mask.geometry);
    for (const Eigen::Vector3d& way : {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(9, 4, -7), Eigen::Vector3d(0, 12, 0),
                                       Eigen::Vector3d(40, 0, 0), Eigen::Vector3d(0.1, 0, 20)}) {
        const BrushStep step{center - 0.3 * way, center + 0.7 * way};
        for (const double radiusMm : {0.7, 3.3, 30.0}) {
            EXPECT_EQ(brushVolume(mask, {BrushMode::Paint, radiusMm}, step).size(), withinStep(mask, radiusMm, step))
                << way.transpose() << ", " << radiusMm;
        }
    }
    mask.geometry.direction = Eigen::Matrix3d::Identity();
    const BrushStep alongRows{center - Eigen::Vector3d(5, 0, 0), center + Eigen::Vector3d(3, 0, 0)};
    EXPECT_EQ(brushVolume(mask, {BrushMode::Paint, 2.2}, alongRows).size(), withinStep(mask, 2.2, alongRows));
}

TEST(MaskEdit, AMaskFinerThanTheSliceIsPaintedAndCutWithoutGaps)
{
    VoxelMask fine(unequalVoxels());
    VolumeGeometry scan = fine.geometry;
    scan.size = {20, 15, 10};
    scan.spacingMm *= 2.0;
    const SliceGrid slice = sliceThrough(scan, BodyPlane::Axial, centerOf(scan));
    const Eigen::Vector3d at = slice.pointAt({10.0, 7.0});
    flip(fine, makeMaskChange(brushSlice(fine, slice, {BrushMode::Paint, 3.0}, {at, at})));
    for (std::size_t place = 0; place < fine.voxels.size(); ++place) {
        const Eigen::Vector3d point = fine.geometry.patientFromVoxel() * fine.geometry.voxelAt(place).cast<double>();
        const double before = slice.distanceMm(point);
        const double away = (point - before * slice.normal - at).norm();
        if (std::abs(before) < 1.9 && away < 2.9) {
            ASSERT_EQ(fine.voxels[place], 1) << point.transpose();
        } else if (std::abs(before) > 2.1 || away > 3.6) {
            ASSERT_EQ(fine.voxels[place], 0) << point.transpose();
        }
    }
    MaskCut cut;
    cut.slice = slice;
    cut.outline = {{1.5, 1.5}, {18.5, 1.5}, {18.5, 13.5}, {1.5, 13.5}};
    flip(fine, makeMaskChange(cutVoxels(fine, cut)));
    EXPECT_EQ(setVoxels(fine), 0U) << "no remnants between the pixels";
}

TEST(MaskEdit, AboveAValueAlone)
{
    VoxelMask mask(unequalVoxels());
    Volume scan(mask.geometry);
    for (std::size_t place = 0; place < scan.voxels.size(); ++place) {
        scan.voxels[place] = static_cast<std::int16_t>(mask.geometry.voxelAt(place).x() < 20 ? 300 : 50);
    }
    const Eigen::Vector3d center = centerOf(mask.geometry);
    const auto found = brushVolume(mask, {BrushMode::Paint, 4.0, &scan, 200.0}, {center, center});
    ASSERT_FALSE(found.empty());
    for (const std::uint32_t place : found) {
        EXPECT_LT(mask.geometry.voxelAt(place).x(), 20);
    }
}

TEST(MaskEdit, ScissorsCutTheSliceARangeOrAll)
{
    const VoxelMask mask = whole();
    MaskCut cut;
    cut.slice = sliceThrough(mask.geometry, BodyPlane::Axial, {0, 0, 0});
    cut.outline = {{9.5, 9.5}, {19.5, 9.5}, {19.5, 14.5}, {9.5, 14.5}};   // 10 by 5 pixels
    EXPECT_EQ(cutVoxels(mask, cut).size(), 50U);
    cut.halfDepthMm = 2.1;
    EXPECT_EQ(cutVoxels(mask, cut).size(), 150U);
    cut.halfDepthMm = std::numeric_limits<double>::infinity();
    EXPECT_EQ(cutVoxels(mask, cut).size(), 1000U);
    cut.side = CutSide::Outside;
    EXPECT_EQ(cutVoxels(mask, cut).size(), mask.voxels.size() - 1000U);
    cut.halfDepthMm = 0.0;
    EXPECT_EQ(cutVoxels(mask, cut).size(), 1200U - 50U);
}

}   // namespace
