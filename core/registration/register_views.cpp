#include "core/registration/register_views.h"

#include "core/messages/says.h"
#include "core/registration/alignment/agreement_score.h"
#include "core/registration/alignment/joint_alignment.h"
#include "core/registration/alignment/shape_tolerance.h"
#include "core/registration/judging/judge_pose.h"
#include "core/registration/judging/pose_uncertainty.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <numbers>

namespace angiopose::core {
namespace {

constexpr double startScalePx = 12.0;
constexpr double endScalePx = 1.0;
constexpr double shrink = 0.7;
constexpr int stepsPerScale = 2;
constexpr int lastSteps = 20;
constexpr double settledViewsMm = 1e-3;
constexpr double implausibleSigmas = 4.0;   // of a correction, in any direction

double mmPerPx(const RegistrationProblem& problem)
{
    const double depthMm = std::max(minProjectableDepthMm, (problem.start * problem.tree.centroid).z());
    return millimetresPerPixel(problem.camera, depthMm);
}

/// One view as the joint solve needs it.
struct JointView {
    RegistrationProblem problem;
    TargetLines lines;
    Alignment alignment;
    AgreementScore score;

    explicit JointView(RegistrationProblem given)
        : problem(std::move(given)),
          lines(problem.target, problem.camera),
          alignment(tellingPoints(problem.tree, mmPerPx(problem)), problem.camera, lines),
          score(problem, lines)
    {
    }
};

/// Registers all views at once, from poses found in single views.
class JointSolve {
public:
    JointSolve(const std::vector<std::unique_ptr<JointView>>& views, const RegistrationOptions& options,
               const MultiViewOptions& multiView);

    /// Pose in the first view that a pose found in view `view` means.
    CentroidPose inFirst(const RigidTransform& pose, std::size_t view) const;

    JointPose refine(const CentroidPose& first);
    double scoreOf(const JointPose& joint);
    CentroidPose inView(const JointPose& joint, std::size_t view) const { return poseInView(joint, geometry_, view); }
    Matrix6d information(const JointPose& joint) const;
    bool isPlausible(const Vector6d& correction) const
    {
        return correction.cwiseQuotient(correctionStd_).cwiseAbs().maxCoeff() < implausibleSigmas;
    }
    const StartPrior& prior() const { return prior_; }

private:
    struct Look {
        double loss = 0.0;
        JointEquations equations;
    };
    Look look(const JointPose& joint, double scalePx);
    void addPriors(const JointPose& joint, double variance, Look& look) const;
    double step(JointPose& joint, Look& current, double scalePx, Damping& damping);

    const std::vector<std::unique_ptr<JointView>>& views_;
    std::vector<ViewGeometry> geometry_;
    StartPrior prior_;
    Vector6d correctionStd_;
};

JointSolve::JointSolve(const std::vector<std::unique_ptr<JointView>>& views, const RegistrationOptions& options,
                       const MultiViewOptions& multiView)
    : views_(views),
      prior_(startPrior(aboutCentroid(views.front()->problem.start, views.front()->problem.tree.centroid), options))
{
    const RigidTransform firstInverse = views.front()->problem.start.inverse();
    for (const auto& view : views) {
        geometry_.push_back({view->problem.start * firstInverse, view->problem.camera});
    }
    const double rotation = multiView.relativeRotationStdDeg * std::numbers::pi / 180.0;
    const double shift = multiView.relativeShiftStdMm;
    correctionStd_ << rotation, rotation, rotation, shift, shift, shift;
}

CentroidPose JointSolve::inFirst(const RigidTransform& pose, std::size_t view) const
{
    return aboutCentroid(geometry_[view].cameraFromFirst.inverse() * pose, views_.front()->problem.tree.centroid);
}

JointSolve::Look JointSolve::look(const JointPose& joint, double scalePx)
{
    Look result;
    std::vector<NormalEquations> perView;
    for (std::size_t k = 0; k < views_.size(); ++k) {
        const Agreement agreement = views_[k]->alignment.look(inView(joint, k), scalePx);
        result.loss += agreement.loss;
        perView.push_back(agreement.equations);
    }
    result.equations = stacked(perView, joint, geometry_);
    addPriors(joint, noiseVariance(scalePx), result);
    return result;
}

void JointSolve::addPriors(const JointPose& joint, double variance, Look& look) const
{
    NormalEquations start;
    prior_.add(joint.first, variance, start);
    look.equations.hessian.topLeftCorner<6, 6>() += Matrix6d(start.hessian.selfadjointView<Eigen::Lower>());
    look.equations.gradient.head<6>() += start.gradient;
    look.loss += variance * prior_.cost(joint.first);
    const Vector6d weight = variance * correctionStd_.cwiseAbs2().cwiseInverse();
    for (std::size_t k = 1; k < views_.size(); ++k) {
        const auto at = static_cast<Eigen::Index>(6 * k);
        look.equations.hessian.block<6, 6>(at, at).diagonal() += weight;
        look.equations.gradient.segment<6>(at) += weight.cwiseProduct(joint.corrections[k]);
        look.loss += joint.corrections[k].dot(weight.cwiseProduct(joint.corrections[k]));
    }
}

/// Tries one step; how far the first pose moved, mm.
double JointSolve::step(JointPose& joint, Look& current, double scalePx, Damping& damping)
{
    Eigen::MatrixXd damped = current.equations.hessian;
    damped.diagonal() *= 1.0 + damping.factor();
    const Eigen::VectorXd step = -damped.ldlt().solve(current.equations.gradient);
    const double promised = -2.0 * current.equations.gradient.dot(step) - step.dot(current.equations.hessian * step);
    const JointPose trial = moved(joint, step);
    Look there = look(trial, scalePx);
    const double gained = current.loss - there.loss;
    if (!(gained >= 0.0 && promised > 0.0)) {
        damping.reject();
        return promised > 0.0 ? step.segment<3>(3).norm() : 0.0;
    }
    damping.accept(gained / promised);
    joint = trial;
    current = std::move(there);
    return views_.front()->problem.tree.spreadMm * step.head<3>().norm() + step.segment<3>(3).norm();
}

JointPose JointSolve::refine(const CentroidPose& first)
{
    JointPose joint{first, std::vector<Vector6d>(views_.size(), Vector6d::Zero())};
    for (const auto& view : views_) {
        view->alignment.resetVisibility();
    }
    for (double scalePx = startScalePx; scalePx >= endScalePx;
         scalePx = scalePx == endScalePx ? 0.0 : std::max(endScalePx, shrink * scalePx)) {
        Damping damping;
        Look current = look(joint, scalePx);
        for (int k = 0; k < (scalePx > endScalePx ? stepsPerScale : lastSteps); ++k) {
            if (step(joint, current, scalePx, damping) < settledViewsMm) {
                break;
            }
        }
    }
    return joint;
}

double JointSolve::scoreOf(const JointPose& joint)
{
    double sum = 0.0;
    for (std::size_t k = 0; k < views_.size(); ++k) {
        sum += views_[k]->score.of(inView(joint, k)) / static_cast<double>(views_.size());
    }
    return sum;
}

/// Of all images about the first pose, the corrections of the geometry being unknown within their spread.
Matrix6d JointSolve::information(const JointPose& joint) const
{
    std::vector<NormalEquations> perView;
    for (std::size_t k = 0; k < views_.size(); ++k) {
        const CentroidPose pose = inView(joint, k);
        StartPrior prior = prior_;
        prior.start = pose;
        perView.push_back(tolerantInformation(views_[k]->alignment, prior, pose));
    }
    Eigen::MatrixXd H = stacked(perView, joint, geometry_).hessian;
    const auto others = static_cast<Eigen::Index>(6 * (views_.size() - 1));
    for (Eigen::Index at = 6; at < H.rows(); at += 6) {
        H.block<6, 6>(at, at).diagonal() += correctionStd_.cwiseAbs2().cwiseInverse();
    }
    const Eigen::MatrixXd towards = H.bottomLeftCorner(others, 6);
    return H.topLeftCorner<6, 6>() - towards.transpose() * H.bottomRightCorner(others, others).ldlt().solve(towards);
}

Result<std::vector<std::unique_ptr<JointView>>> makeViews(std::span<const RegistrationInput> inputs,
                                                          const RegistrationOptions& options)
{
    if (inputs.size() < 2) {
        return Error(says::viewsTooFew());
    }
    if (isAnyLocked(options.locks)) {
        return Error(says::viewsCannotLock());
    }
    std::vector<std::unique_ptr<JointView>> views;
    for (std::size_t k = 0; k < inputs.size(); ++k) {
        auto problem = makeProblem(inputs[k], options);
        if (!problem) {
            return inView(k, problem.error());
        }
        views.push_back(std::make_unique<JointView>(std::move(problem).value()));
        const TreeSamples& tree = views.back()->problem.tree;
        const TreeSamples& firstTree = views.front()->problem.tree;
        if (tree.size() != firstTree.size() || (tree.centroid - firstTree.centroid).norm() > 1e-6) {
            return Error(says::viewsOfOtherTree(k + 1));
        }
    }
    return views;
}

/// Tells of a run in one of several views as of a part of the whole.
IterationObserver observerInView(const IterationObserver& observe, std::size_t index, std::size_t count)
{
    if (!observe) {
        return {};
    }
    return [&observe, index, count](IterationReport report) {
        report.view = index;
        report.progress = (static_cast<double>(index) + report.progress) / static_cast<double>(count);
        return observe(report);
    };
}

/// Every view's own answers, carried to the first view, are where the joint solve starts from; the best score wins.
Result<JointPose> bestJointPose(JointSolve& solve, std::span<const RegistrationInput> inputs,
                                const RegistrationOptions& options, const IterationObserver& observe)
{
    JointPose best;
    double bestScore = -1.0;
    for (std::size_t k = 0; k < inputs.size(); ++k) {
        const auto alone = registerVessels(inputs[k], options, observerInView(observe, k, inputs.size()));
        if (!alone) {
            return inView(k, alone.error());
        }
        std::vector<RigidTransform> starts{alone.value().cameraFromPatient};
        for (const Hypothesis& other : alone.value().alternatives) {
            starts.push_back(other.cameraFromPatient);
        }
        for (const RigidTransform& start : starts) {
            const JointPose joint = solve.refine(solve.inFirst(start, k));
            if (const double score = solve.scoreOf(joint); score > bestScore) {
                best = joint;
                bestScore = score;
            }
        }
        if (alone.value().stopReason == StopReason::StoppedByUser) {
            break;
        }
    }
    return best;
}

/// Judges one view at the joint pose; what speaks against it is added to the result's warnings.
void addView(MultiViewResult& result, const JointView& view, const CentroidPose& jointPose, bool isPlausible,
             const RegistrationOptions& options)
{
    MethodSolution solution;
    solution.cameraFromPatient = cameraFromPatient(jointPose, view.problem.tree.centroid);
    solution.stopReason = StopReason::Converged;
    result.views.push_back(judgePose(view.problem, options, solution));
    result.views.back().method = options.method;
    const std::size_t number = result.views.size();
    if (!result.views.back().trustworthy) {
        result.trustworthy = false;
        result.warnings.push_back(says::viewDisagrees(number));
    }
    if (!isPlausible) {
        result.trustworthy = false;
        result.warnings.push_back(says::viewFarFromHeader(number));
    }
}

}   // namespace

Result<MultiViewResult> registerViews(std::span<const RegistrationInput> inputs, const RegistrationOptions& options,
                                      const MultiViewOptions& multiView, const IterationObserver& observe)
{
    auto made = makeViews(inputs, options);
    if (!made) {
        return made.error();
    }
    const auto& views = made.value();
    JointSolve solve(views, options, multiView);
    const auto best = bestJointPose(solve, inputs, options, observe);
    if (!best) {
        return best.error();
    }

    const JointPose& pose = best.value();
    MultiViewResult result;
    result.corrections = pose.corrections;
    result.uncertainty =
        poseUncertainty(solve.information(pose), solve.prior(), pose.first, views.front()->problem.tree.spreadMm);
    result.trustworthy = true;
    for (std::size_t k = 0; k < views.size(); ++k) {
        addView(result, *views[k], solve.inView(pose, k), solve.isPlausible(pose.corrections[k]), options);
    }
    return result;
}

Error inView(std::size_t index, const Error& error)
{
    return error.isStop() ? error : Error(says::inView(index + 1, error.message));
}

}   // namespace angiopose::core