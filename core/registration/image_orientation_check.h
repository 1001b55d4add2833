#pragma once

#include "core/registration/alignment/pose_search.h"
#include "core/registration/problem/method_solution.h"
#include "core/registration/problem/registration_problem.h"

namespace angiopose::core {

/// What speaks for an image that is stored mirrored or turned (ALGORITHMS §6.20).
struct ImageOrientationCheck {
    std::optional<Message> message;
    bool shakesTrust = false;   ///< the fit was trusted, and is no longer
};

/// After a fit that failed: whether a mirrored or turned reading of the frame explains the image clearly better. After
/// one that is trusted but explains it middlingly, or of few branches: whether the mirrored frame does as well. Takes
/// up to a second: `observe` hears of it and may stop it, then nothing is known.
ImageOrientationCheck checkImageOrientation(const RegistrationProblem& problem, const RegistrationOptions& options,
                                            const MethodSolution& solution, const RegistrationResult& judged,
                                            const SearchObserver& observe);

}   // namespace angiopose::core
