#pragma once

#include "core/imaging/image2d.h"
#include "core/registration/problem/registration_problem.h"

#include <Eigen/Core>

namespace angiopose::core {

/// Returns the input image of intensity-based methods, at the camera's size: vessels bright on a background of 0, the
/// strongest about 1. Uses the background-corrected angiogram or, if there is none, the traced vessels drawn as tubes.
ImageF vesselImage(const RegistrationProblem& problem);

/// Returns the image gradient at a pixel position, by central differences of bilinear samples; zero outside the image.
Eigen::Vector2d gradientAt(const ImageF& image, const Eigen::Vector2d& position);

/// Whether a pixel position is inside the image.
bool isInside(const ImageF& image, const Eigen::Vector2d& position);

}   // namespace angiopose::core
