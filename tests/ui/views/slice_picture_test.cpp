#include "tests/support/for_each.h"
#include "ui/slices/slice_image.h"
#include "ui/slices/slice_model.h"
#include "ui/slices/window_bar.h"

#include <gtest/gtest.h>
#include <QPushButton>

#include <algorithm>
#include <limits>

namespace angiopose::ui {
namespace {

/// 8 × 8 pixels of 1 × 2 mm with the values 0, 100, … 700 from left to right.
SliceContent rampSlice()
{
    SliceContent content;
    content.grid.width = content.grid.height = 8;
    content.grid.rowStep = {0.0, 2.0, 0.0};
    test::forEachPixel(8, 8,
                       [&](int column, int /*row*/) { content.values.push_back(100.0F * static_cast<float>(column)); });
    return content;
}

/// Ten widget px per mm: the whole slice fills 80 × 160.
ImageViewport fittedViewport()
{
    ImageViewport viewport;
    viewport.setImageSize(8, 16);
    viewport.setWidgetSize(80, 160);
    viewport.fit();
    return viewport;
}

constexpr GrayWindow wholeRamp{800.0, 400.0};

QRgb middleOf(const QImage& picture, int column, int row, int scale = 1)
{
    return picture.pixel(scale * (10 * column + 5), scale * (20 * row + 5));
}

TEST(SlicePicture, ShowsTheWindowAndInterpolates)
{
    const QImage picture = sliceImage(rampSlice(), wholeRamp, {}, fittedViewport(), {80, 160}, 1.0);
    for (const int column : {0, 3, 7}) {
        EXPECT_NEAR(qRed(middleOf(picture, column, 2)), 255.0 * column / 8.0, 7.0);
        EXPECT_EQ(qRed(middleOf(picture, column, 2)), qBlue(middleOf(picture, column, 2)));
    }
    const int between = qRed(picture.pixel(40, 50));   // between columns 3 and 4
    EXPECT_GT(between, qRed(middleOf(picture, 3, 2)));
    EXPECT_LT(between, qRed(middleOf(picture, 4, 2)));
    EXPECT_EQ(middleOf(sliceImage(rampSlice(), {10.0, 900.0}, {}, fittedViewport(), {80, 160}, 1.0), 7, 7),
              qRgb(0, 0, 0));
    EXPECT_EQ(middleOf(sliceImage(rampSlice(), {10.0, -90.0}, {}, fittedViewport(), {80, 160}, 1.0), 0, 0),
              qRgb(255, 255, 255));
}

TEST(SlicePicture, TintsLumenAndWhatIsAboveTheThreshold)
{
    SliceContent content = rampSlice();
    content.mask.assign(64, 0);
    content.mask[8 * 4 + 1] = 1;
    SliceTints tints{{{{0, 0, 255}, 0.5}}, {{255, 0, 0}, 0.5}, 450.0};
    const QImage picture = sliceImage(content, wholeRamp, tints, fittedViewport(), {80, 160}, 1.0);
    EXPECT_GT(qBlue(middleOf(picture, 1, 4)), qRed(middleOf(picture, 1, 4)));
    EXPECT_EQ(qBlue(middleOf(picture, 1, 3)), qRed(middleOf(picture, 1, 3)));
    EXPECT_EQ(qBlue(middleOf(picture, 4, 4)), qRed(middleOf(picture, 4, 4)));
    EXPECT_GT(qRed(middleOf(picture, 5, 4)), qBlue(middleOf(picture, 5, 4)));
}

TEST(SlicePicture, TintsEachLabelInItsColor)
{
    SliceContent content = rampSlice();
    content.values.clear();
    content.mask.assign(64, 0);
    content.mask[8 * 4 + 1] = 1;
    content.mask[8 * 4 + 3] = 2;
    content.mask[8 * 4 + 5] = 200;   // beyond the list of tints: uses the last one
    const SliceTints tints{{{{0, 0, 255}, 1.0}, {{0, 200, 0}, 0.5}}, {}, std::nullopt};
    const QImage picture = sliceImage(content, wholeRamp, tints, fittedViewport(), {80, 160}, 1.0);
    EXPECT_EQ(middleOf(picture, 0, 4), qRgb(0, 0, 0));
    EXPECT_EQ(middleOf(picture, 1, 4), qRgb(0, 0, 255));
    EXPECT_EQ(middleOf(picture, 3, 4), qRgb(0, 100, 0));
    EXPECT_EQ(middleOf(picture, 5, 4), middleOf(picture, 3, 4));
}

TEST(SlicePicture, IsBlackOutsideTheScan)
{
    SliceContent content = rampSlice();
    content.values[0] = std::numeric_limits<float>::quiet_NaN();
    const SliceTints everything{{{{0, 0, 255}, 0.5}}, {{255, 0, 0}, 0.5}, -1e9};
    const QImage picture = sliceImage(content, {10.0, -90.0}, everything, fittedViewport(), {200, 160}, 1.0);
    EXPECT_EQ(middleOf(picture, 0, 0), qRgb(0, 0, 0));
    EXPECT_NE(middleOf(picture, 4, 4), qRgb(0, 0, 0));
    EXPECT_EQ(picture.pixel(190, 80), qRgb(0, 0, 0));
    EXPECT_EQ(sliceImage({}, wholeRamp, {}, fittedViewport(), {80, 160}, 1.0).pixel(40, 80), qRgb(0, 0, 0));
}

TEST(SlicePicture, IsTheSameOnAFineScreen)
{
    const QImage coarse = sliceImage(rampSlice(), wholeRamp, {}, fittedViewport(), {80, 160}, 1.0);
    const QImage fine = sliceImage(rampSlice(), wholeRamp, {}, fittedViewport(), {160, 320}, 2.0);
    for (const int column : {0, 3, 7}) {
        EXPECT_NEAR(qRed(middleOf(fine, column, 5, 2)), qRed(middleOf(coarse, column, 5)), 6);
    }
}

std::shared_ptr<core::Volume> airyVolume()
{
    core::VolumeGeometry geometry;
    geometry.size = {20, 20, 20};
    return std::make_shared<core::Volume>(geometry, std::int16_t{-1000});
}

std::shared_ptr<core::Volume> countedVolume()
{
    core::VolumeGeometry geometry;
    geometry.size = {20, 20, 20};
    auto volume = std::make_shared<core::Volume>(geometry);
    for (std::size_t i = 0; i < volume->voxels.size(); ++i) {
        volume->voxels[i] = static_cast<std::int16_t>(i % 1000);
    }
    return volume;
}

TEST(SliceModel, ChoosesTheWindowByTheKindOfScan)
{
    SliceModel model;
    model.setScan(airyVolume(), nullptr);
    EXPECT_TRUE(model.isHounsfield());
    EXPECT_EQ(model.window(), windowPresets().front().window);

    model.setScan(countedVolume(), nullptr);
    EXPECT_FALSE(model.isHounsfield());
    EXPECT_NEAR(model.window().level, 500.0, 60.0);
    EXPECT_NEAR(model.window().width, 980.0, 60.0);
}

TEST(WindowBar, OffersTheWindowsOfCtForCtAlone)
{
    SliceModel model;
    WindowBar bar(model);
    const auto offered = [&bar] {
        return std::ranges::count_if(bar.findChildren<QPushButton*>(), [&bar](const QPushButton* button) {
            return button->property("role") == "quiet" && button->isVisibleTo(&bar);
        });
    };
    bar.resize(1200, 40);
    model.setScan(airyVolume(), nullptr);
    EXPECT_EQ(offered(), static_cast<std::ptrdiff_t>(windowPresets().size()) + 1);
    model.setScan(countedVolume(), nullptr);
    EXPECT_EQ(offered(), 1);   // only "Automatic"
}

TEST(SliceModel, KeepsTheCrosshairWithinTheScan)
{
    core::VolumeGeometry geometry;
    geometry.size = {11, 11, 11};
    SliceModel model;
    model.setCrosshair({3, 3, 3});
    EXPECT_TRUE(model.crosshair().isZero());   // no volume to clamp to yet
    model.setScan(nullptr, std::make_shared<const core::VoxelMask>(geometry));
    EXPECT_EQ(model.crosshair(), Eigen::Vector3d(5, 5, 5));
    model.setCrosshair({3, 40, -7});
    EXPECT_EQ(model.crosshair(), Eigen::Vector3d(3, 10, 0));
}

}   // namespace
}   // namespace angiopose::ui
