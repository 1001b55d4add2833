#pragma once

#include "core/registration/alignment/pose_search.h"
#include "core/registration/problem/method_solution.h"
#include "core/registration/problem/registration_problem.h"

namespace angiopose::core {

/// Evidence that an image is stored mirrored or rotated (ALGORITHMS §6.20).
struct ImageOrientationCheck {
    std::optional<Message> message;
    bool shakesTrust = false;   ///< whether a reliable fit becomes unreliable
};

/// After a failed fit: checks whether a mirrored or rotated reading of the frame explains the image clearly better.
/// After a reliable fit with medium agreement or of few branches: checks whether the mirrored frame fits equally well.
/// Takes up to a second; `observe` reports progress and may stop it, which leaves the check without a result.
ImageOrientationCheck checkImageOrientation(const RegistrationProblem& problem, const RegistrationOptions& options,
                                            const MethodSolution& solution, const RegistrationResult& judged,
                                            const SearchObserver& observe);

}   // namespace angiopose::core
