#include "core/tracing/angiogram/frame/field_mask.h"

#include "tests/support/drawn_vessels.h"
#include "tests/support/for_each.h"

#include <gtest/gtest.h>
#include <cmath>

using namespace angiopose;

namespace {

using core::ImageF;
using core::Mask2d;

constexpr int side = 300;

/// A round angiogram on a uniform gray page with noise; the left half of the angiogram is as dark as a shutter.
ImageF roundPictureOn(float page)
{
    ImageF frame(side, side);
    test::forEachPixel(side, side, [&](int x, int y) {
        const bool isInside = std::hypot(x - 150.0, y - 150.0) < 130.0;
        frame.at(x, y) = isInside ? 60.0F + 0.35F * static_cast<float>(x) : page;
    });
    test::addNoise(frame, 2.0, 3);
    return frame;
}

double shareInField(const Mask2d& field, double nearest, double farthest)
{
    int inside = 0;
    int all = 0;
    test::forEachPixel(side, side, [&](int x, int y) {
        const double distance = std::hypot(x - 150.0, y - 150.0);
        if (distance >= nearest && distance <= farthest) {
            inside += field.at(x, y) != 0 ? 1 : 0;
            ++all;
        }
    });
    return static_cast<double>(inside) / all;
}

TEST(FieldMask, EndsBeforeTheShutterAndWhatIsNotExposed)
{
    Mask2d shutter(side, side, 255);
    test::forEachPixel(100, side, [&](int x, int y) { shutter.at(x, y) = 0; });
    const Mask2d field = core::findField(roundPictureOn(5.0F), 16.0, shutter);
    EXPECT_EQ(field.at(103, 150), 0) << "on its edge";
    EXPECT_EQ(field.at(105, 150), 255);
    EXPECT_EQ(field.at(285, 150), 0) << "beyond the round field";
    EXPECT_EQ(core::findField(roundPictureOn(5.0F), 16.0).at(50, 150), 255);
}

TEST(FieldMask, LeavesOutDarkAndLightSurrounds)
{
    for (const float page : {5.0F, 240.0F}) {
        const Mask2d field = core::findField(roundPictureOn(page), 16.0);
        EXPECT_GT(shareInField(field, 0.0, 118.0), 0.99) << page;
        EXPECT_LT(shareInField(field, 131.0, 400.0), 0.01) << page;
    }
}

TEST(FieldMask, KeepsWhatIsBrightAtOneSide)
{
    ImageF frame(side, side, 90.0F);
    test::forEachPixel({220, 0}, {side, side}, [&](int x, int y) { frame.at(x, y) = 230.0F; });
    test::addNoise(frame, 2.0, 3);
    EXPECT_GT(shareInField(core::findField(frame, 16.0), 0.0, 400.0), 0.99);
}

}   // namespace
