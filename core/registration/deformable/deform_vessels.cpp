#include "core/registration/deformable/deform_vessels.h"

#include "core/geometry/angle_units.h"
#include "core/registration/deformable/classify_deformation.h"
#include "core/registration/deformable/deformation_fit.h"
#include "core/registration/deformable/deformation_problem.h"
#include "core/registration/deformable/deformed_result.h"
#include "core/registration/deformable/evidence_gain.h"
#include "core/support/random.h"
#include "core/support/stopwatch.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr std::array<double, 3> strainsTried{0.15, 0.08, 0.2};   // strains of the successive fits, at most one fit each
constexpr int annealingSteps = 14;
constexpr double firstAnnealingMm = 3.5;
constexpr double lastAnnealingMm = 0.1;
constexpr int learningFrom = 6;
constexpr double coarseAboveMm = 0.5;
constexpr int settlingSteps = 4;   // extra steps of the best fit
constexpr double allSteps = annealingSteps * static_cast<double>(strainsTried.size()) + settlingSteps;
constexpr double clearlyRigidGain = -1.0;   // log evidence below which the first fit shows that the tree is rigid
constexpr double maxFitDifferenceMm =
    0.1;   // RMS difference in the image plane of the first view below which two fits agree
constexpr double startTurnDeg = 0.5;   // 1-σ rotation of a fit's starting point from the rigid pose
constexpr double startShiftMm = 1.0;

/// Reports every step of every fit to the observer.
class DeformationProgress {
public:
    explicit DeformationProgress(const IterationObserver& observe) : observe_(observe) {}

    ObserverDecision report(const DeformationFit& fit, double annealingPx)
    {
        IterationReport report;
        report.stage = "bending";
        report.iteration = ++iterations_;
        report.progress = static_cast<double>(iterations_) / allSteps;
        report.scalePx = annealingPx;
        report.medianDistancePx = fit.medianResidualPx();
        report.cameraFromPatient = fit.deformedTree().cameraFromPatient;
        isStopped_ = isStopped_ || (observe_ && observe_(report) == ObserverDecision::Stop);
        return isStopped_ ? ObserverDecision::Stop : ObserverDecision::Continue;
    }

    bool isStopped() const { return isStopped_; }
    int iterations() const { return iterations_; }

private:
    const IterationObserver& observe_;
    int iterations_ = 0;
    bool isStopped_ = false;
};

double annealingMm(int step)
{
    const double share = static_cast<double>(step) / (annealingSteps - 1);
    return firstAnnealingMm * std::pow(lastAnnealingMm / firstAnnealingMm, share);
}

DeformationState randomInitialState(const DeformationProblem& problem, std::size_t run, int seed)
{
    DeformationState state = initialState(problem, strainsTried[run]);
    if (run > 0) {
        CounterRandom random = CounterRandom(static_cast<std::uint64_t>(seed)).fork(run);
        for (Eigen::Index k = 0; k < 6; ++k) {
            state.poseStep[k] = random.normal() * (k < 3 ? startTurnDeg / degreesPerRadian : startShiftMm);
        }
    }
    return state;
}

DeformationFit annealed(const DeformationProblem& problem, std::size_t run, int seed, DeformationProgress& progress)
{
    DeformationFit fit(problem, randomInitialState(problem, run, seed));
    const double mmPerPx = millimetersPerPixel(problem.views.front().camera, problem.start.centroidInCamera.z());
    for (int k = 0; k < annealingSteps && !progress.isStopped(); ++k) {
        fit.step({annealingMm(k), strainsTried[run], k >= learningFrom, annealingMm(k) > coarseAboveMm});
        progress.report(fit, annealingMm(k) / mmPerPx);
    }
    return fit;
}

/// Iterates until the variances converge, which takes long if there is little motion.
void settleVariances(DeformationFit& fit, double strain, DeformationProgress& progress)
{
    for (int k = 0; k < settlingSteps && !progress.isStopped(); ++k) {
        fit.step({lastAnnealingMm, strain, true, false});
        progress.report(fit, 0.0);
    }
}

double rmsApartMm(const DeformationProblem& problem, const DeformationFit& a, const DeformationFit& b)
{
    const KnotPositions here = knotPositionsInCamera(problem, a);
    const KnotPositions there = knotPositionsInCamera(problem, b);
    double squares = 0.0;
    for (std::size_t k = 0; k < here.size(); ++k) {
        squares += (here[k] - there[k]).head<2>().squaredNorm();
    }
    return std::sqrt(squares / static_cast<double>(here.size()));
}

/// Whether the fits so far make further ones unnecessary.
bool isSufficient(const DeformationProblem& problem, const std::vector<DeformationFit>& fits)
{
    return fits.size() == 1 ? logEvidenceGain(problem, fits.front()) < clearlyRigidGain
                            : rmsApartMm(problem, fits[0], fits[1]) < maxFitDifferenceMm;
}

/// Returns the index of the fit with the highest likelihood of all observations: rows count by their evidence, knots
/// without a row at the background density.
std::size_t likeliestFit(const std::vector<DeformationFit>& fits)
{
    const auto best = std::ranges::max_element(fits, {}, &DeformationFit::logLikelihood);
    return static_cast<std::size_t>(best - fits.begin());
}

}   // namespace

Result<DeformableResult> deformVessels(std::span<const DeformableView> views, const DeformableOptions& options,
                                       const IterationObserver& observe)
{
    Stopwatch stopwatch;
    const auto problemOrError = makeDeformationProblem(views, options);
    if (!problemOrError) {
        return problemOrError.error();
    }
    const DeformationProblem& problem = problemOrError.value();
    DeformationProgress progress(observe);
    std::vector<DeformationFit> fits;
    for (std::size_t run = 0; run < strainsTried.size() && !progress.isStopped(); ++run) {
        fits.push_back(annealed(problem, run, options.randomSeed, progress));
        if (!progress.isStopped() && isSufficient(problem, fits)) {
            break;
        }
    }
    const std::size_t best = likeliestFit(fits);
    settleVariances(fits[best], strainsTried[best], progress);
    DeformableResult result;
    if (progress.isStopped()) {
        result = rigidResult(views);
        result.stopReason = StopReason::StoppedByUser;
    } else {
        result = deformedResult(views, problem, fits, best);
        result.logEvidenceGain = logEvidenceGain(problem, fits[best]);
    }
    result.iterations = progress.iterations();
    classifyDeformation(views, result);
    result.timeMs = stopwatch.takeLapMs();
    return result;
}

}   // namespace angiopose::core
