#include "core/registration/picture/vessel_image.h"

#include "core/imaging/gray_statistics.h"
#include "core/imaging/image_filters.h"
#include "core/registration/picture/tube_image.h"
#include "core/tracing/angiogram/frame/field_mask.h"
#include "core/tracing/angiogram/frame/flatten_background.h"

#include <algorithm>

namespace angiopose::core {
namespace {

constexpr double widestVesselPx = 16.0;
constexpr double surroundingsPx = 24.0;
constexpr std::size_t pictureSamples = 100000;
constexpr double drawnBlurPx = 0.7;   // typical detector blur, applied to drawn tubes

ImageF flattened(const ImageF& image, Polarity polarity, const Mask2d& shutter)
{
    ImageF vesselsDark = image;
    if (polarity == Polarity::VesselsBright) {
        for (float& value : vesselsDark.pixels) {
            value = -value;
        }
    }
    return flattenBackground(vesselsDark, findField(vesselsDark, widestVesselPx, shutter), surroundingsPx);
}

}   // namespace

ImageF vesselImage(const RegistrationProblem& problem)
{
    const ProjectionCamera& camera = problem.camera;
    ImageF picture = problem.image
                         ? flattened(*problem.image, problem.polarity, problem.shutter ? *problem.shutter : Mask2d())
                         : gaussianBlur(renderTubes(problem.target, camera.width, camera.height), drawnBlurPx);
    const float top = std::max(grayQuantile(subsample(picture.pixels, pictureSamples), 0.999), 1e-12F);
    for (float& value : picture.pixels) {
        value = std::max(0.0F, value / top);
    }
    return picture;
}

Eigen::Vector2d gradientAt(const ImageF& image, const Eigen::Vector2d& position)
{
    if (!isInside(image, position)) {
        return Eigen::Vector2d::Zero();
    }
    const auto at = [&](double x, double y) { return static_cast<double>(sampleBilinear(image, x, y)); };
    return {0.5 * (at(position.x() + 1.0, position.y()) - at(position.x() - 1.0, position.y())),
            0.5 * (at(position.x(), position.y() + 1.0) - at(position.x(), position.y() - 1.0))};
}

bool isInside(const ImageF& image, const Eigen::Vector2d& position)
{
    return position.x() >= 0.0 && position.y() >= 0.0 && position.x() <= image.width - 1 &&
           position.y() <= image.height - 1;
}

}   // namespace angiopose::core
