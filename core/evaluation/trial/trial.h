#pragma once

#include "core/registration/registration.h"

#include <memory>
#include <optional>

namespace angiopose::core {

/// One registration of an experiment: what the methods get, and what only the judge knows.
struct Trial {
    RegistrationInput input;
    std::shared_ptr<const VesselTree> tree;   ///< errors are measured on its points; input.tree may lack branches
    RigidTransform trueCameraFromPatient;
    bool hasRightAnswer = true;   ///< false: no pose is right, a method can only say so; its errors stay unknown
    bool targetIsExact = false;   ///< every target point is the projection of a tree point
    std::optional<Matrix6d> errorBound;   ///< Cramér–Rao covariance about the tree's centroid, where it is known
    std::optional<double> traceMs;   ///< to get the target from the image, where there was one
};

}   // namespace angiopose::core