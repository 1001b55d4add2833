#include "core/registration/alignment/final_refinement.h"

#include "core/registration/alignment/alignment_points.h"
#include "core/registration/alignment/shape_tolerance.h"

#include <algorithm>

namespace angiopose::core {
namespace {

constexpr std::size_t fewPoints = 400;
constexpr double spacedPx = 3.0;   // tracing noise is correlated over about 5 px: closer points are redundant
constexpr RefinementSchedule fewSchedule{2.5, 1.0, 0.7, 2, 4, 20};

}   // namespace

FinalRefinement::FinalRefinement(const RegistrationProblem& problem, const TargetLines& target,
                                 const InitialPosePrior& prior, const RegistrationOptions& options)
    : problem_(problem),
      prior_(prior),
      options_(options),
      target_(target),
      sparseAlignment_(alignmentPoints(problem.tree, strideFor(problem.tree.size(), fewPoints)), problem.camera, target)
{
}

RefinementResult FinalRefinement::refine(const CentroidPose& pose, const RefinementObserver& observe)
{
    sparseAlignment_.resetVisibility();
    RefinementResult result = core::refine(sparseAlignment_, prior_, pose, fewSchedule);
    if (!fullAlignment_) {
        const double depthMm = std::max(minProjectableDepthMm, pose.centroidInCamera.z());
        const double mmPerPx = millimetersPerPixel(problem_.camera, depthMm);
        spacedAlignment_.emplace(informativePoints(problem_.tree, mmPerPx, spacedPx), problem_.camera, target_);
        fullAlignment_.emplace(informativePoints(problem_.tree, mmPerPx), problem_.camera, target_);
    }
    spacedAlignment_->resetVisibility();
    const double startScalePx = std::max(result.scalePx, options_.finalScalePx);
    const RefinementSchedule schedule{startScalePx, options_.finalScalePx, 0.7, 2, 20, options_.maxIterations, true};
    result = core::refine(*spacedAlignment_, prior_, result.pose, schedule, observe);
    if (result.stopReason != StopReason::StoppedByUser) {
        fullAlignment_->setVisibility(spacedAlignment_->evaluate(result.pose, result.scalePx));
        result.pose = refineWithShapeErrors(*fullAlignment_, prior_, result.pose, result.scalePx);
    }
    return result;
}

}   // namespace angiopose::core
