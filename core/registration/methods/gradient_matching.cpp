#include "core/registration/methods/methods.h"

#include "core/imaging/image_filters.h"
#include "core/registration/methods/pose_trials.h"
#include "core/registration/picture/vessel_image.h"
#include "core/registration/pose/minimize.h"
#include "core/registration/pose/pose_parameters.h"
#include "core/support/stopwatch.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr int evaluationsPerRound = 60;   // estimate: six line searches of about ten evaluations each
constexpr double minGradientCosine = 0.7071;   // cosine of 45°
constexpr double unknownWallRadiusMm = 1.0;

/// Agreement between image gradients and wall normals, for both projected walls of every vessel.
class WallAgreement {
public:
    WallAgreement(const RegistrationProblem& problem, double scalePx)
        : problem_(problem), picture_(gaussianBlur(vesselImage(problem), scalePx))
    {
    }

    /// Returns the weighted mean over all walls; never negative.
    double of(const RigidTransform& pose) const;

private:
    double atWall(const Eigen::Vector3d& wall, const Eigen::Vector3d& inwards) const;

    const RegistrationProblem& problem_;
    ImageF picture_;
};

double WallAgreement::of(const RigidTransform& pose) const
{
    const TreeSamples& tree = problem_.tree;
    double sum = 0.0;
    double weights = 0.0;
    for (std::size_t i = 0; i < tree.size(); ++i) {
        const double radiusMm = tree.radiusMm[i] > 0.0 ? tree.radiusMm[i] : unknownWallRadiusMm;
        const double weight = std::clamp(radiusMm, 0.5, 3.0);
        weights += 2.0 * weight;
        const Eigen::Vector3d center = pose * tree.points[i];
        const Eigen::Vector3d across = center.cross(pose.rotation * tree.tangents[i]);
        if (center.z() < minProjectableDepthMm || across.norm() < 0.1 * center.norm()) {
            continue;   // no walls behind the source or for vessels seen end-on
        }
        const Eigen::Vector3d normal = across.normalized();
        sum += weight * (atWall(center + radiusMm * normal, -normal) + atWall(center - radiusMm * normal, normal));
    }
    return sum / weights;
}

/// Returns the inward component of the gradient times the squared cosine of its angle to the normal; zero beyond 45°.
double WallAgreement::atWall(const Eigen::Vector3d& wall, const Eigen::Vector3d& inwards) const
{
    const auto pixel = project(problem_.camera, wall);
    if (!pixel) {
        return 0.0;
    }
    const Eigen::Vector2d direction = (projectionJacobian(problem_.camera, wall) * inwards).normalized();
    const Eigen::Vector2d gradient = gradientAt(picture_, *pixel);
    const double inwardsPart = direction.dot(gradient);
    const double strength = gradient.norm();
    if (inwardsPart < minGradientCosine * strength || strength <= 0.0) {
        return 0.0;
    }
    const double cosine = inwardsPart / strength;
    return inwardsPart * cosine * cosine;
}

}   // namespace

MethodSolution solveGradientMatching(const RegistrationProblem& problem, const RegistrationOptions& options,
                                     ProgressLog& progress)
{
    Stopwatch stopwatch;
    const WallAgreement agreement(problem, options.gradient.scalePx);
    const double targetMs = stopwatch.takeLapMs();

    const int budget = evaluationsPerRound * options.gradient.powellRounds;
    PoseTrials search(problem, budget, progress);
    search.startStage("walls", options.gradient.scalePx, std::numeric_limits<double>::infinity());
    const PoseParameters parameters(search.start(), clinicalUnits(1.0, 2.0, 2.0, 10.0), problem.freedom);
    MinimizeOptions powell;
    powell.minimizer = Minimizer::Powell;
    powell.firstStep = 1.0;
    powell.tolerance = 1e-3;
    powell.maxEvaluations = budget;
    const Minimum minimum = minimize(
        [&](const Eigen::VectorXd& x, Eigen::VectorXd&) {
            const CentroidPose pose = parameters.pose(x);
            return search.recordTrial(pose, -agreement.of(search.rigidPose(pose)));
        },
        parameters.origin(), powell, [&] { return search.isStopped(); });

    MethodSolution solution = search.solution(minimum.isConverged ? StopReason::Converged : StopReason::IterationLimit);
    solution.time.targetMs = targetMs;
    solution.time.solveMs = stopwatch.takeLapMs();
    return solution;
}

}   // namespace angiopose::core
