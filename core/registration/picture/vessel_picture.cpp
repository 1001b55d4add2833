#include "core/registration/picture/vessel_picture.h"

#include "core/imaging/gray_statistics.h"
#include "core/imaging/image_filters.h"
#include "core/registration/picture/tube_picture.h"
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

ImageF vesselPicture(const RegistrationProblem& problem)
{
    const ProjectionCamera& camera = problem.camera;
    ImageF picture = problem.image
                         ? flattened(*problem.image, problem.polarity, problem.shutter ? *problem.shutter : Mask2d())
                         : blurred(pictureOf(problem.target, camera.width, camera.height), drawnBlurPx);
    const float top = std::max(ranked(evenSample(picture.pixels, pictureSamples), 0.999), 1e-12F);
    for (float& value : picture.pixels) {
        value = std::max(0.0F, value / top);
    }
    return picture;
}

Eigen::Vector2d gradientAt(const ImageF& image, const Eigen::Vector2d& place)
{
    if (!isOn(image, place)) {
        return Eigen::Vector2d::Zero();
    }
    const auto at = [&](double x, double y) { return static_cast<double>(sampled(image, x, y)); };
    return {0.5 * (at(place.x() + 1.0, place.y()) - at(place.x() - 1.0, place.y())),
            0.5 * (at(place.x(), place.y() + 1.0) - at(place.x(), place.y() - 1.0))};
}

bool isOn(const ImageF& image, const Eigen::Vector2d& place)
{
    return place.x() >= 0.0 && place.y() >= 0.0 && place.x() <= image.width - 1 && place.y() <= image.height - 1;
}

}   // namespace angiopose::core
