#pragma once

#include "core/registration/alignment/graduated_refinement.h"

#include <optional>

namespace angiopose::core {

/// From a roughly refined pose to the answer: few points until the noise shows, then points as far apart as the noise
/// is shared, at last tolerance of the tree's shape errors with all that can tell more (ALGORITHMS §6.5, §6.14).
class FinalRefinement {
public:
    FinalRefinement(const RegistrationProblem& problem, const TargetLines& target, const StartPrior& prior,
                    const RegistrationOptions& options);

    RefinementResult refine(const CentroidPose& pose, const RefinementObserver& observe);

private:
    const RegistrationProblem& problem_;
    const StartPrior& prior_;
    const RegistrationOptions& options_;
    const TargetLines& target_;
    Alignment few_;
    std::optional<Alignment> spaced_;   ///< made when first needed, as the next: their spacing follows from the depth
    std::optional<Alignment> all_;
};

}   // namespace angiopose::core