#include "core/viewing/scan/render_scan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr int side = 60;

bool always()
{
    return true;
}

/// A sphere of 400 HU, 8 mm wide, around a point in 0 HU; 1 mm voxels around the origin.
std::shared_ptr<const Volume> ballAt(const Eigen::Vector3d& center)
{
    VolumeGeometry geometry;
    geometry.size = {side, side, side};
    geometry.originInPatient.setConstant(-0.5 * (side - 1));
    auto volume = std::make_shared<Volume>(geometry);
    for (std::size_t i = 0; i < volume->voxels.size(); ++i) {
        const Eigen::Vector3d at = geometry.patientFromVoxel() * geometry.voxelAt(i).cast<double>();
        volume->voxels[i] = (at - center).norm() <= 8.0 ? 400 : 0;
    }
    return volume;
}

/// Frontal view, head up.
ParallelProjection seenFromTheFront()
{
    ParallelProjection projection;
    projection.right = Eigen::Vector3d::UnitX();
    projection.up = Eigen::Vector3d::UnitZ();
    projection.width = 61;
    projection.height = 41;
    return projection;
}

ScanAppearance solid(double perMm)
{
    ScanAppearance appearance;
    appearance.rest = {100.0, 300.0, perMm};
    appearance.vessels = appearance.rest;
    appearance.brightFrom = 300.0;
    appearance.softTissueColor = appearance.boneColor = {1.0F, 1.0F, 1.0F};
    appearance.kinds = {{1.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 1.0F}};
    return appearance;
}

TEST(CastScan, ShowsABallWhereItLies)
{
    const auto scan = prepareVolume({ballAt({9, 3, -6}), nullptr, nullptr}, always);
    ASSERT_TRUE(scan);
    const auto picture = renderScan(*scan, solid(5.0), seenFromTheFront(), 0.5, always);
    ASSERT_TRUE(picture);
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    double mass = 0.0;
    for (int y = 0; y < picture->height; ++y) {
        for (int x = 0; x < picture->width; ++x) {
            const double opacity = picture->at(x, y)[3] / 255.0;
            sum += opacity * Eigen::Vector2d(x - 30.0, y - 20.0);
            mass += opacity;
        }
    }
    EXPECT_NEAR(sum.x() / mass, 9.0, 0.1);
    EXPECT_NEAR(sum.y() / mass, -6.0, 0.1);   // the lowest row comes first
    EXPECT_NEAR(mass, M_PI * 64.0, 20.0);
    EXPECT_GT(picture->at(39, 14)[3], 250);
    EXPECT_EQ(picture->at(10, 30)[3], 0);
}

/// The view of a window that was never painted.
TEST(CastScan, ShowsNothingToASightThatIsNowhere)
{
    const auto scan = prepareVolume({ballAt({0, 0, 0}), nullptr, nullptr}, always);
    ASSERT_TRUE(scan);
    ParallelProjection projection = seenFromTheFront();
    projection.mmPerPx = 1.0 / 0.0;
    const auto far = renderScan(*scan, solid(5.0), projection, 0.5, always);
    ASSERT_TRUE(far);
    EXPECT_TRUE(std::ranges::all_of(far->pixels, [](const Rgba& pixel) { return pixel == Rgba{}; }));
    projection = seenFromTheFront();
    projection.up = Eigen::Vector3d::Constant(std::nan(""));
    EXPECT_TRUE(renderScan(*scan, solid(5.0), projection, 0.5, always));
    projection.width = 0;
    EXPECT_TRUE(renderScan(*scan, solid(5.0), projection, 0.5, always));
}

/// The opacity along a path of known length does not depend on the step size.
TEST(CastScan, HidesAsMuchAsTheWayThroughDemands)
{
    const auto scan = prepareVolume({ballAt({0, 0, 0}), nullptr, nullptr}, always);
    ASSERT_TRUE(scan);
    for (const double step : {0.3, 0.5, 1.0}) {
        const auto picture = renderScan(*scan, solid(0.05), seenFromTheFront(), step, always);
        ASSERT_TRUE(picture);
        EXPECT_NEAR(picture->at(30, 20)[3] / 255.0, 1.0 - std::exp(-0.05 * 16.4), 0.03) << step;
    }
}

TEST(CastScan, SeesTheSameFromEverySideOfABall)
{
    const auto scan = prepareVolume({ballAt({0, 0, 0}), nullptr, nullptr}, always);
    ASSERT_TRUE(scan);
    ParallelProjection oblique = seenFromTheFront();
    oblique.right = Eigen::Vector3d(1, 1, 0.5).normalized();
    oblique.up = oblique.right.unitOrthogonal();
    const auto a = renderScan(*scan, solid(0.1), seenFromTheFront(), 0.5, always);
    const auto b = renderScan(*scan, solid(0.1), oblique, 0.5, always);
    ASSERT_TRUE(a && b);
    for (const auto& [x, y] : {std::pair(30, 20), {34, 20}, {30, 26}}) {
        EXPECT_NEAR(a->at(x, y)[3], b->at(x, y)[3], 8);
    }
}

TEST(CastScan, TintsWhatTheMaskNames)
{
    const auto volume = ballAt({0, 0, 0});
    auto labels = std::make_shared<VoxelMask>(volume->geometry);
    for (std::size_t i = 0; i < labels->voxels.size(); ++i) {
        const int x = labels->geometry.voxelAt(i).x();
        labels->voxels[i] = volume->voxels[i] == 0 ? 0 : x < side / 2 ? 1 : 2;
    }
    for (const auto& shown : {std::shared_ptr<const Volume>(volume),
                              std::shared_ptr<const Volume>()}) {   // with the scan or with the labels only
        const auto scan = prepareVolume({shown, labels, nullptr}, always);
        ASSERT_TRUE(scan);
        const AppearanceOptions request{ScanPreset::Vessels, 0.9, {}, {}, {{1.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 1.0F}}};
        const ScanAppearance appearance =
            shown ? appearanceFor({0.0, 200.0, 400.0, true}, request, true) : maskAppearance(request);
        const auto picture = renderScan(*scan, appearance, seenFromTheFront(), 0.5, always);
        ASSERT_TRUE(picture);
        EXPECT_GT(picture->at(26, 20)[0], picture->at(26, 20)[2] + 100);   // red on the left
        EXPECT_GT(picture->at(34, 20)[2], picture->at(34, 20)[0] + 100);
    }
}

TEST(CastScan, LeavesOutTheRestWhereVesselsAreKnown)
{
    const auto volume = ballAt({12, 0, 0});   // bone, without any vessel information
    auto tree = std::make_shared<VesselTree>();
    tree->branches.emplace_back();
    tree->branches.front().pointsInPatient = {{-12, 0, -10}, {-12, 0, 10}};
    tree->branches.front().radiusMm = {2.0, 2.0};
    const auto scan = prepareVolume({volume, nullptr, tree}, always);
    ASSERT_TRUE(scan && scan->hasVesselLabels);
    const IntensityLevels levels{0.0, 200.0, 400.0, true};
    const auto opacityAt = [&](ScanPreset preset) {
        const AppearanceOptions request{preset, 0.8, {}, {}, {{1.0F, 0.0F, 0.0F}}};
        return renderScan(*scan, appearanceFor(levels, request, scan->hasVesselLabels), seenFromTheFront(), 0.5, always)
            ->at(42, 20)[3];
    };
    EXPECT_EQ(opacityAt(ScanPreset::Vessels), 0);
    EXPECT_GT(opacityAt(ScanPreset::VesselsAndBone), 150);
}

TEST(CastScan, EndsWhenItIsReported)
{
    const auto scan = prepareVolume({ballAt({0, 0, 0}), nullptr, nullptr}, always);
    ASSERT_TRUE(scan);
    EXPECT_FALSE(renderScan(*scan, solid(1.0), seenFromTheFront(), 0.5, [] { return false; }));
    EXPECT_FALSE(prepareVolume({ballAt({0, 0, 0}), nullptr, nullptr}, [] { return false; }));
    EXPECT_FALSE(prepareVolume({}, always));
}

/// In a scan without HU, voxels brighter than nearly all others count as vessel, based on the scan's own values.
TEST(ScanAppearance, FindsTheBrightOfAScanWithoutUnits)
{
    VolumeGeometry geometry;
    geometry.size = {50, 50, 50};
    Volume volume(geometry);
    for (std::size_t i = 0; i < volume.voxels.size(); ++i) {
        volume.voxels[i] = static_cast<std::int16_t>(i % 100 == 0 ? 250 : 40 + static_cast<int>(i % 37));
    }
    const IntensityLevels levels = estimateLevels(volume, {});
    EXPECT_FALSE(levels.isHu);
    EXPECT_GT(levels.wall, 70.0);
    EXPECT_LE(levels.wall, 250.0);
    EXPECT_EQ(estimateLevels(volume, 120.0).wall, 120.0);
    const ScanAppearance appearance = appearanceFor(levels, {}, false);
    EXPECT_EQ(appearance.vessels.at(50.0), 0.0);
    EXPECT_GT(appearance.vessels.at(250.0), 0.0);
}

}   // namespace
}   // namespace angiopose::core
