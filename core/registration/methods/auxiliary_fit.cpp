#include "core/registration/methods/auxiliary_fit.h"

#include "core/registration/alignment/alignment_points.h"

#include <array>

namespace angiopose::core {
namespace {

/// Welsch scales; the first captures auxiliary branches that are displaced because the other vessels have moved.
constexpr std::array scalesPx{8.0, 3.0};
constexpr int maxAuxiliarySteps = 20;

/// Returns the information that all branches and the prior provide about pose steps, in px of residual.
Matrix6d informationOfAll(const RegistrationProblem& problem, const TargetLines& target, const InitialPosePrior& prior,
                          const CentroidPose& pose)
{
    const Alignment all(alignmentPoints(problem.tree), problem.camera, target);
    const Matrix6d lower = all.evaluate(pose, scalesPx.back()).equations.hessian;
    return Matrix6d(lower.selfadjointView<Eigen::Lower>()) + prior.informationAt(pose);
}

}   // namespace

AuxiliaryFit fitAuxiliaryBranches(const RegistrationProblem& problem, const TargetLines& target,
                                  const InitialPosePrior& prior, const CentroidPose& fullFit, double weight)
{
    Alignment chosen(alignmentPoints(problem.tree, problem.auxiliary), problem.camera, target);
    const Matrix6d information = informationOfAll(problem, target, prior, fullFit) / weight;
    std::vector<double> distances;
    AuxiliaryFit fit;
    fit.medianBeforePx = chosen.medianDistancePx(fullFit, distances);
    fit.pose = fullFit;
    for (const double scalePx : scalesPx) {
        // A refinement weights its prior with the variance that corresponds to the scale; dividing by this variance
        // cancels the weight and leaves both terms in px.
        const InitialPosePrior known{fullFit, information / noiseVariance(scalePx), prior.freedom};
        chosen.resetVisibility();
        fit.pose =
            refine(chosen, known, fit.pose, {scalePx, scalePx, 0.7, 0, maxAuxiliarySteps, maxAuxiliarySteps}).pose;
    }
    fit.medianPx = chosen.medianDistancePx(fit.pose, distances);
    if (fit.medianPx >= fit.medianBeforePx) {
        fit.pose = fullFit;
        fit.medianPx = fit.medianBeforePx;
    }
    return fit;
}

}   // namespace angiopose::core
