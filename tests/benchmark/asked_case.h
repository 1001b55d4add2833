#pragma once

#include "core/registration/problem/registration_result.h"

#include <string>
#include <vector>

namespace angiopose::benchmarks {

/// A registration problem with its true answer, from any generator.
struct RequestedCase {
    std::string tree;   ///< cases of one tree are not independent
    std::string kind;
    core::RegistrationInput input;
    core::ProjectionCamera trueCamera;   ///< `input` may state a wrong camera
    /// True positions of the points of each branch of the input's tree, in the true camera; empty if the image does not
    /// show the branch.
    std::vector<std::vector<Eigen::Vector3d>> trueInCamera;
    bool isImpossible = false;   ///< another tree, or a mirrored image: every answer is wrong
};

/// Overlay error of a pose: mean distance over the points of the shown vessels from their true positions, mm at their
/// depth. A wrong camera does not count as an error where the overlay fits nevertheless.
double overlayErrorMm(const RequestedCase& asked, const core::RigidTransform& cameraFromPatient);

}   // namespace angiopose::benchmarks
