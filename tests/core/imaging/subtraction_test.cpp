#include "core/imaging/subtraction.h"

#include "core/imaging/image_filters.h"
#include "core/support/random.h"
#include "tests/support/drawn_vessels.h"
#include "tests/support/for_each.h"

#include <gtest/gtest.h>
#include <cmath>

using namespace angiopose;

namespace {

using core::ImageF;
using core::PixelRelation;

/// Photon counts behind a body with structures of a few px, shifted.
ImageF body(const Eigen::Vector2d& shift, double noise, std::uint64_t seed)
{
    ImageF field(200, 160);
    core::CounterRandom random(4);
    for (float& value : field.pixels) {
        value = static_cast<float>(random.normal());
    }
    field = core::gaussianBlur(field, 3.0);
    ImageF counts(160, 120);
    test::forEachPixel(counts.width, counts.height, [&](int x, int y) {
        const double attenuation = core::sampleBilinear(field, x + 20 - shift.x(), y + 20 - shift.y());
        counts.at(x, y) = static_cast<float>(1000.0 * std::exp(-2.0 * attenuation));
    });
    test::addNoise(counts, noise, seed);
    return counts;
}

/// Adds a vessel with a transmission of 60 %.
ImageF withVessel(ImageF counts)
{
    const ImageF shadow =
        test::drawnFrame(160, 120, {test::line({10, 20}, {150, 100})}, 4.0, {.background = 0.0F, .depth = 0.5F});
    for (std::size_t i = 0; i < counts.pixels.size(); ++i) {
        counts.pixels[i] *= std::exp(shadow.pixels[i]);
    }
    return counts;
}

double deviation(const ImageF& image, int margin)
{
    double sum = 0.0;
    double squares = 0.0;
    double count = 0.0;
    test::forEachPixel({margin, margin}, {image.width - margin, image.height - margin}, [&](int x, int y) {
        sum += image.at(x, y);
        squares += std::pow(image.at(x, y), 2);
        count += 1.0;
    });
    return std::sqrt(squares / count - std::pow(sum / count, 2));
}

TEST(MaskShift, IsFoundToAFractionOfAPixelInSpiteOfTheVessel)
{
    for (const Eigen::Vector2d& truth : {Eigen::Vector2d(0.0, 0.0), {1.3, -0.7}, {-4.6, 3.2}}) {
        const ImageF mask = body({0.0, 0.0}, 8.0, 1);
        const ImageF frame = withVessel(body(truth, 8.0, 2));
        EXPECT_LT((core::findMaskShift(mask, frame, PixelRelation::Linear) - truth).norm(), 0.1) << truth.transpose();
    }
}

TEST(MaskShift, IsZeroWhereNothingTells)
{
    const ImageF plain(100, 100, 50.0F);
    EXPECT_EQ(core::findMaskShift(plain, plain, PixelRelation::Linear), Eigen::Vector2d(0.0, 0.0));
    const ImageF tiny(2, 2, 50.0F);
    EXPECT_EQ(core::findMaskShift(tiny, tiny, PixelRelation::Linear), Eigen::Vector2d(0.0, 0.0));
}

TEST(Subtracted, ShowsTheVesselAndNothingOfTheBody)
{
    const Eigen::Vector2d shift(1.3, -0.7);
    const ImageF mask = body({0.0, 0.0}, 0.0, 1);
    const ImageF frame = withVessel(body(shift, 0.0, 2));
    const ImageF difference = core::subtracted(frame, mask, shift, PixelRelation::Linear);
    const ImageF empty = core::subtracted(body(shift, 0.0, 2), mask, shift, PixelRelation::Linear);
    EXPECT_LT(deviation(empty, 5), 0.05 * deviation(frame, 5));
    EXPECT_LT(difference.at(80, 60), difference.at(80, 20)) << "the vessel stays dark";
    const double middle = difference.at(80, 20);
    EXPECT_NEAR((difference.at(80, 60) - middle) / middle, -0.5, 0.08) << "by its own attenuation, wherever it lies";
    EXPECT_NEAR((difference.at(45, 40) - middle) / middle, -0.5, 0.08);
}

TEST(Subtracted, LogarithmicValuesAreSubtractedAsTheyAre)
{
    ImageF mask(20, 20, 300.0F);
    ImageF frame = mask;
    frame.at(10, 10) -= 70.0F;
    mask.at(3, 3) += 40.0F;
    frame.at(3, 3) += 40.0F;
    const ImageF difference = core::subtracted(frame, mask, {0.0, 0.0}, PixelRelation::Logarithmic);
    EXPECT_FLOAT_EQ(difference.at(10, 10), 230.0F);
    EXPECT_FLOAT_EQ(difference.at(3, 3), 300.0F);
}

TEST(MeanFrame, AveragesTheChosenOnes)
{
    const std::vector<ImageF> frames{ImageF(2, 1, 1.0F), ImageF(2, 1, 50.0F), ImageF(2, 1, 4.0F)};
    EXPECT_FLOAT_EQ(core::meanFrame(frames, {0, 2}).at(1, 0), 2.5F);
    EXPECT_TRUE(core::meanFrame(frames, {}).isEmpty());
}

TEST(OpacifiedComposite, TakesEachPixelWhereItIsFilledMost)
{
    ImageF early(3, 1, 100.0F);
    ImageF late = early;
    early.at(0, 0) = 20.0F;
    late.at(2, 0) = 30.0F;
    late.at(1, 0) = 120.0F;
    const std::vector<ImageF> frames{early, ImageF(1, 1, 0.0F), late};
    EXPECT_EQ(core::peakOpacificationImage(frames, core::Polarity::VesselsDark).pixels,
              (std::vector<float>{20.0F, 100.0F, 30.0F}));
    EXPECT_EQ(core::peakOpacificationImage(frames, core::Polarity::VesselsBright).pixels,
              (std::vector<float>{100.0F, 120.0F, 100.0F}));
    EXPECT_TRUE(core::peakOpacificationImage({}, core::Polarity::VesselsDark).isEmpty());
}

}   // namespace
