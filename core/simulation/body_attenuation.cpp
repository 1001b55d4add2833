#include "core/simulation/body_attenuation.h"

#include "core/imaging/wide_blur.h"
#include "core/simulation/splat_disc.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace angiopose::core {
namespace {

/// Returns a smooth random field with standard deviation `amplitude` and grain size `sigmaPx`.
ImageF randomField(int width, int height, double sigmaPx, CounterRandom& random)
{
    ImageF field(width, height);
    for (float& value : field.pixels) {
        value = static_cast<float>(random.normal());
    }
    return widelyBlurred(field, sigmaPx);
}

void addScaled(ImageF& image, const ImageF& field, double standardDeviation)
{
    double squares = 0.0;
    for (const float value : field.pixels) {
        squares += static_cast<double>(value) * value;
    }
    const double rms = std::sqrt(squares / static_cast<double>(field.pixels.size()));
    const auto scale = static_cast<float>(rms > 0.0 ? standardDeviation / rms : 0.0);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        image.pixels[i] += scale * field.pixels[i];
    }
}

/// A long shallow arc across the image.
struct Arc {
    Eigen::Vector2d centerPx;
    double radiusPx;
    double fromRad;
    double toRad;

    Eigen::Vector2d at(double t) const
    {
        const double angle = fromRad + t * (toRad - fromRad);
        return centerPx + radiusPx * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    }
    double lengthPx() const { return radiusPx * std::abs(toRad - fromRad); }
};

Arc drawArc(const ImageF& image, CounterRandom& random)
{
    const double size = std::max(image.width, image.height);
    const double angle = random.uniform(0.0, 2.0 * std::numbers::pi);
    const double radiusPx = size * random.uniform(0.5, 1.2);
    const Eigen::Vector2d crossing(random.uniform(0.1, 0.9) * image.width, random.uniform(0.1, 0.9) * image.height);
    const Eigen::Vector2d center = crossing - radiusPx * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    const double halfSpan = 1.2 * size / radiusPx;
    return {center, radiusPx, angle - halfSpan, angle + halfSpan};
}

/// Adds discs along the arc, which form a tube with attenuation `peak` at its axis.
void addTubeAlong(ImageF& image, const Arc& arc, double radiusPx, double peak)
{
    const double stepPx = std::max(0.5, 0.15 * radiusPx);
    const int steps = static_cast<int>(arc.lengthPx() / stepPx);
    const double value = peak * stepPx / (2.0 * radiusPx);
    for (int k = 0; k <= steps; ++k) {
        splatDisc(image, arc.at(static_cast<double>(k) / steps), radiusPx, value);
    }
}

/// Adds hollow tubes: cortical bone shows as two bright rims.
void addBones(ImageF& image, double size, CounterRandom& random)
{
    const int bones = 2 + random.index(4);
    for (int i = 0; i < bones; ++i) {
        const Arc arc = drawArc(image, random);
        const double radiusPx = size * random.uniform(0.015, 0.04);
        const double peak = random.uniform(0.15, 0.5);
        const double wall = random.uniform(0.12, 0.25);
        addTubeAlong(image, arc, radiusPx, peak);
        addTubeAlong(image, arc, (1.0 - wall) * radiusPx, -0.75 * (1.0 - wall) * peak);
    }
}

}   // namespace

ImageF bodyAttenuation(int width, int height, CounterRandom& random)
{
    const double size = std::max(width, height);
    ImageF body(width, height);
    addScaled(body, randomField(width, height, 0.14 * size, random), 0.22);
    addScaled(body, randomField(width, height, 0.03 * size, random), 0.06);
    addScaled(body, randomField(width, height, 2.2, random), 0.02);
    addBones(body, size, random);
    if (random.uniform() < 0.3) {
        addTubeAlong(body, drawArc(body, random), 0.0022 * size, 0.25);
    }
    return body;
}

}   // namespace angiopose::core