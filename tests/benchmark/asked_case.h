#pragma once

#include "core/registration/problem/registration_result.h"

#include <string>
#include <vector>

namespace angiopose::benchmarks {

/// One question to the solver with its answer, whatever generator made it.
struct AskedCase {
    std::string tree;   ///< cases of one tree are not independent
    std::string kind;
    core::RegistrationInput input;
    core::ProjectionCamera trueCamera;   ///< what `input` says of it may be wrong
    /// Where the points of each branch of the input's tree are in truth, in the true camera; empty: the image does not
    /// show the branch.
    std::vector<std::vector<Eigen::Vector3d>> trueInCamera;
    bool isImpossible = false;   ///< another tree, or a mirrored image: every answer is wrong
};

/// How far the overlay of a pose lies from where the shown vessels are in truth: mean over their points, mm at their
/// depth. A wrong camera under which the overlay fits all the same is no error of it.
double overlayErrorMm(const AskedCase& asked, const core::RigidTransform& cameraFromPatient);

}   // namespace angiopose::benchmarks
