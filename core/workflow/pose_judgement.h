#pragma once

#include "core/registration/registration.h"

#include <map>
#include <vector>

namespace angiopose::core {

/// How a pose agrees with the image, as a whole and at every point of the tree.
struct PoseJudgement {
    RegistrationResult result;   ///< of evaluatePose
    std::map<int, std::vector<double>> residualPx;   ///< per branch id, one value per tree point, see branchDistances
};

/// Judges a pose without moving it. Fails as evaluatePose.
Result<PoseJudgement> judgementOf(const RegistrationInput& input, const RigidTransform& cameraFromPatient);

}   // namespace angiopose::core
