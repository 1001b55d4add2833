#pragma once

#include "core/registration/alignment/exact_partners.h"
#include "core/registration/alignment/graduated_refinement.h"

#include <optional>

namespace angiopose::core {

/// From a roughly refined pose to the answer: few points until the noise shows, then all that can tell more, then what
/// the data allow beyond that (exact partners, or tolerance of the tree's shape errors).
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
    ExactPartners partners_;
    Alignment few_;
    std::optional<Alignment> all_;   ///< made when first needed: exact partners never do
};

}   // namespace angiopose::core