#pragma once

#include "core/imaging/image2d.h"
#include "core/registration/problem/registration_problem.h"

#include <Eigen/Core>

namespace angiopose::core {

/// Input image of intensity-based methods: vessels bright on 0, the strongest about 1, in the camera's size. Uses the
/// angiogram with its background flattened, or the traced vessels drawn as tubes if no angiogram is available.
ImageF vesselPicture(const RegistrationProblem& problem);

/// Image gradient at a position in px, by central differences of bilinear samples; zero outside the image.
Eigen::Vector2d gradientAt(const ImageF& image, const Eigen::Vector2d& place);

/// Whether a position is inside the image.
bool isOn(const ImageF& image, const Eigen::Vector2d& place);

}   // namespace angiopose::core