#pragma once

#include "core/registration/alignment/pose_search.h"
#include "core/registration/problem/method_solution.h"
#include "core/registration/problem/registration_problem.h"

namespace angiopose::core {

/// Result of checking whether an image is stored mirrored or rotated (ALGORITHMS §6.20).
struct ImageOrientationCheck {
    std::optional<Message> message;
    bool invalidatesFit = false;   ///< whether the finding makes a reliable fit unreliable
};

/// After a failed fit, checks whether a mirrored or rotated image explains the vessels clearly better. After a reliable
/// fit with medium agreement or with few branches, checks whether the mirrored image fits equally well. Takes up to a
/// second; `observe` receives the progress, and if it returns Stop, the check has no result.
ImageOrientationCheck checkImageOrientation(const RegistrationProblem& problem, const RegistrationOptions& options,
                                            const MethodSolution& solution, const RegistrationResult& assessed,
                                            const SearchObserver& observe);

}   // namespace angiopose::core
