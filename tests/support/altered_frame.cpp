#include "tests/support/altered_frame.h"

#include "core/imaging/image_filters.h"
#include "tests/support/drawn_vessels.h"
#include "tests/support/for_each.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace angiopose::test {
namespace {

using core::ImageF;

constexpr std::uint64_t frameNoiseSeed = 7;

template <class Map>
DrawnFrame mappedFrame(DrawnFrame drawn, const Map& map)
{
    for (float& value : drawn.frame.pixels) {
        value = map(value);
    }
    return drawn;
}

/// Resamples to `width` × `height` pixels; `from` maps a pixel center to its position in the image. Positions outside
/// are black.
template <class From>
ImageF resampled(const ImageF& image, int width, int height, const From& from)
{
    ImageF result(width, height);
    test::forEachPixel(width, height, [&](int x, int y) {
        const Eigen::Vector2d at = from(Eigen::Vector2d(x, y));
        const bool isInside =
            at.x() >= -0.5 && at.y() >= -0.5 && at.x() <= image.width - 0.5 && at.y() <= image.height - 0.5;
        result.at(x, y) = isInside ? core::sampleBilinear(image, at.x(), at.y()) : 0.0F;
    });
    return result;
}

template <class From>
DrawnFrame resampled(const DrawnFrame& drawn, int width, int height, const From& from)
{
    return {resampled(drawn.frame, width, height, from), resampled(drawn.truth, width, height, from), drawn.polarity};
}

DrawnFrame scaled(const DrawnFrame& drawn, double factor)
{
    const double blurPx = factor < 1.0 ? 0.5 / factor : 0.0;   // against aliasing
    DrawnFrame smooth{core::gaussianBlur(drawn.frame, blurPx), core::gaussianBlur(drawn.truth, blurPx), drawn.polarity};
    const auto size = [factor](int pixels) { return static_cast<int>(std::lround(factor * pixels)); };
    return resampled(smooth, size(drawn.frame.width), size(drawn.frame.height), [factor](const Eigen::Vector2d& at) {
        return Eigen::Vector2d((at.array() + 0.5) / factor - 0.5);
    });
}

/// Crops a frame at (`left`, `top`), with all values as shares of the side lengths.
DrawnFrame croppedFrame(const DrawnFrame& drawn, double left, double top, double width, double height)
{
    const Eigen::Vector2d sides(drawn.frame.width, drawn.frame.height);
    const Eigen::Vector2d corner = sides.cwiseProduct(Eigen::Vector2d(left, top)).array().round();
    return resampled(drawn, static_cast<int>(width * sides.x()), static_cast<int>(height * sides.y()),
                     [corner](const Eigen::Vector2d& at) { return Eigen::Vector2d(at + corner); });
}

DrawnFrame turned(const DrawnFrame& drawn, double angleDeg)
{
    const Eigen::Vector2d middle(0.5 * (drawn.frame.width - 1), 0.5 * (drawn.frame.height - 1));
    const Eigen::Matrix2d turn = Eigen::Rotation2Dd(angleDeg * std::numbers::pi / 180.0).toRotationMatrix();
    return resampled(drawn, drawn.frame.width, drawn.frame.height,
                     [&](const Eigen::Vector2d& at) { return Eigen::Vector2d(turn * (at - middle) + middle); });
}

DrawnFrame mirrored(const DrawnFrame& drawn)
{
    const double last = drawn.frame.width - 1;
    return resampled(drawn, drawn.frame.width, drawn.frame.height,
                     [last](const Eigen::Vector2d& at) { return Eigen::Vector2d(last - at.x(), at.y()); });
}

/// Surrounds the image with a black frame, as viewers and video grabbers do.
DrawnFrame framed(const DrawnFrame& drawn, int widthPx)
{
    return resampled(drawn, drawn.frame.width + 2 * widthPx, drawn.frame.height + 2 * widthPx,
                     [widthPx](const Eigen::Vector2d& at) { return Eigen::Vector2d(at.array() - widthPx); });
}

DrawnFrame noisyFrame(DrawnFrame drawn, double sigma)
{
    addNoise(drawn.frame, sigma, frameNoiseSeed);
    return drawn;
}

DrawnFrame bright(DrawnFrame drawn)
{
    drawn = mappedFrame(std::move(drawn), [](float value) { return 255.0F - value; });
    drawn.polarity = core::Polarity::VesselsBright;
    return drawn;
}

using Block = Eigen::Matrix<float, 8, 8>;

/// Matrix of JPEG's transform, with one cosine per row.
Block cosines()
{
    Block basis;
    for (int k = 0; k < 8; ++k) {
        for (int x = 0; x < 8; ++x) {
            basis(k, x) = static_cast<float>((k == 0 ? std::sqrt(0.125) : 0.5) *
                                             std::cos((2 * x + 1) * k * std::numbers::pi / 16.0));
        }
    }
    return basis;
}

/// Applies the loss of JPEG: cosines of 8 × 8 pixels, quantized in steps that grow with the frequency.
DrawnFrame compressed(DrawnFrame drawn, float step)
{
    const Block basis = cosines();
    ImageF& image = drawn.frame;
    for (int top = 0; top + 8 <= image.height; top += 8) {
        for (int left = 0; left + 8 <= image.width; left += 8) {
            Eigen::Map<Eigen::Matrix<float, 8, 8, Eigen::RowMajor>, 0, Eigen::OuterStride<>> pixels(
                &image.at(left, top), Eigen::OuterStride<>(image.width));
            Block block = basis * pixels * basis.transpose();
            test::forEachPixel(8, 8, [&](int u, int v) {
                const float size = step * (1.0F + 0.5F * static_cast<float>(u + v));
                block(v, u) = size * std::round(block(v, u) / size);
            });
            pixels = basis.transpose() * block * basis;
        }
    }
    return drawn;
}

DrawnFrame gaussianBlur(DrawnFrame drawn, double sigmaPx)
{
    drawn.frame = core::gaussianBlur(drawn.frame, sigmaPx);
    return drawn;
}

float power(float value, double exponent)
{
    return 255.0F * static_cast<float>(std::pow(std::max(0.0F, value) / 255.0F, exponent));
}

}   // namespace

std::vector<FrameChange> frameChanges()
{
    using D = const DrawnFrame&;
    return {
        {"as it is", [](D d) { return d; }},
        {"half as large", [](D d) { return scaled(d, 0.5); }},
        {"1.5 x as large", [](D d) { return scaled(d, 1.5); }},
        {"2 x as large", [](D d) { return scaled(d, 2.0); }},
        {"1024 x 1024", [](D d) { return scaled(d, 1024.0 / d.frame.width); }},
        {"1024 x 1024, noise 5", [](D d) { return noisyFrame(scaled(d, 1024.0 / d.frame.width), 5.0); }},
        {"16 bit", [](D d) { return mappedFrame(d, [](float v) { return 100.0F * v - 4000.0F; }); }},
        {"gamma 0.5", [](D d) { return mappedFrame(d, [](float v) { return power(v, 0.5); }); }},
        {"gamma 2", [](D d) { return mappedFrame(d, [](float v) { return power(v, 2.0); }); }},
        {"half the contrast", [](D d) { return mappedFrame(d, [](float v) { return 90.0F + std::round(0.5F * v); }); }},
        {"20 grey values", [](D d) { return mappedFrame(d, [](float v) { return 12.0F * std::round(v / 12.0F); }); }},
        {"vessels bright", [](D d) { return bright(d); }},
        {"noise 5", [](D d) { return noisyFrame(d, 5.0); }},
        {"noise 10", [](D d) { return noisyFrame(d, 10.0); }},
        {"blurred 1 px", [](D d) { return gaussianBlur(d, 1.0); }},
        {"JPEG, light", [](D d) { return compressed(d, 6.0F); }},
        {"JPEG, heavy", [](D d) { return compressed(d, 15.0F); }},
        {"cropped all round", [](D d) { return croppedFrame(d, 0.1, 0.1, 0.8, 0.8); }},
        {"left upper part", [](D d) { return croppedFrame(d, 0.0, 0.0, 0.7, 0.6); }},
        {"black frame", [](D d) { return framed(d, 40); }},
        {"mirrored", [](D d) { return mirrored(d); }},
        {"turned 90 deg", [](D d) { return turned(d, 90.0); }},
        {"turned 20 deg", [](D d) { return turned(d, 20.0); }},
    };
}

}   // namespace angiopose::test
