#pragma once

#include "core/registration/alignment/graduated_refinement.h"

#include <optional>

namespace angiopose::core {

/// Refines a coarsely refined pose to the final result in three passes: with few points until the noise level is known,
/// with points spaced at the correlation length of the noise, and with all informative points and tolerance for shape
/// errors of the tree (ALGORITHMS §6.5, §6.14).
class FinalRefinement {
public:
    FinalRefinement(const RegistrationProblem& problem, const TargetLines& target, const InitialPosePrior& prior,
                    const RegistrationOptions& options);

    RefinementResult refine(const CentroidPose& pose, const RefinementObserver& observe);

private:
    const RegistrationProblem& problem_;
    const InitialPosePrior& prior_;
    const RegistrationOptions& options_;
    const TargetLines& target_;
    Alignment sparseAlignment_;
    std::optional<Alignment> spacedAlignment_;   ///< created on first use, like fullAlignment_, because the point
                                                 ///< spacing depends on the depth
    std::optional<Alignment> fullAlignment_;
};

}   // namespace angiopose::core
