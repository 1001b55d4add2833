#pragma once

#include "core/imaging/image2d.h"
#include "core/registration/problem/registration_problem.h"

#include <Eigen/Core>

namespace angiopose::core {

/// What the methods that read the image see: vessels bright on 0, the strongest about 1, of the camera's size. The
/// angiogram with its background flattened; where none is at hand, the traced vessels drawn as tubes.
ImageF vesselPicture(const RegistrationProblem& problem);

/// Gradient of an image at a place in px, by central differences of bilinear samples; zero outside the image.
Eigen::Vector2d gradientAt(const ImageF& image, const Eigen::Vector2d& place);

/// Whether a place lies on the image.
bool isOn(const ImageF& image, const Eigen::Vector2d& place);

}   // namespace angiopose::core