#include "core/registration/alignment/joint_solver.h"

#include "core/registration/alignment/alignment_points.h"
#include "core/registration/alignment/camera_influence.h"
#include "core/registration/alignment/shape_tolerance.h"
#include "core/support/symmetric.h"

#include <algorithm>
#include <utility>

namespace angiopose::core {
namespace {

constexpr double jointStartScalePx = 12.0;
constexpr double jointEndScalePx = 1.0;
constexpr double jointShrink = 0.7;
constexpr int jointStepsPerScale = 2;
constexpr int jointLastSteps = 20;
constexpr double settledJointMm = 1e-3;
constexpr double implausibleSigmas = 4.0;   // maximum plausible correction in any direction

double mmPerPx(const RegistrationProblem& problem)
{
    const double depthMm = std::max(minProjectableDepthMm, (problem.start * problem.tree.centroid).z());
    return millimetersPerPixel(problem.camera, depthMm);
}

/// Cost and normal equations of all images at one joint pose.
struct JointEvaluation {
    double loss = 0.0;
    StackedEquations equations;
};

/// Least-squares problem of all images at one scale, with the priors of the first pose and of the corrections.
class JointAtScale {
public:
    using State = JointPose;
    using Step = Eigen::VectorXd;
    using Evaluation = JointEvaluation;
    using Equations = StackedEquations;

    JointAtScale(const JointSolver::Views& views, const std::vector<RelativeCamera>& geometry,
                 const InitialPosePrior& prior, const std::vector<Vector6d>& correctionStd)
        : views_(views), geometry_(geometry), prior_(prior), correctionStd_(correctionStd)
    {
    }

    bool evaluate(const JointPose& joint, JointEvaluation& evaluation) const
    {
        std::vector<NormalEquations> perView;
        evaluation.loss = 0.0;
        for (std::size_t k = 0; k < views_.size(); ++k) {
            const AlignmentEvaluation agreement =
                views_[k]->alignment.evaluate(poseInView(joint, geometry_, k), scalePx_);
            evaluation.loss += agreement.loss;
            perView.push_back(agreement.equations);
        }
        evaluation.equations = stackEquations(perView, joint, geometry_);
        addPriors(joint, evaluation);
        return true;
    }

    const StackedEquations& equations(const JointPose&, const JointEvaluation& evaluation) const
    {
        return evaluation.equations;
    }

    Eigen::VectorXd step(const JointPose&, const StackedEquations& equations, double damping) const
    {
        return dampedStep(equations, damping);
    }

    JointPose retract(const JointPose& joint, const Eigen::VectorXd& step) const { return core::retract(joint, step); }

    std::optional<double> decrease(const JointEvaluation& here, const JointEvaluation& there) const
    {
        return there.loss <= here.loss ? std::optional(here.loss - there.loss) : std::nullopt;
    }

    double lengthMm(const JointPose&, const Eigen::VectorXd& step) const
    {
        return jointStepLengthMm(step, views_.front()->problem.tree.spreadMm);
    }

    double scalePx() const { return scalePx_; }
    void setScale(double scalePx) { scalePx_ = scalePx; }

private:
    void addPriors(const JointPose& joint, JointEvaluation& evaluation) const;

    const JointSolver::Views& views_;
    const std::vector<RelativeCamera>& geometry_;
    const InitialPosePrior& prior_;
    const std::vector<Vector6d>& correctionStd_;
    double scalePx_ = jointStartScalePx;
};

void JointAtScale::addPriors(const JointPose& joint, JointEvaluation& evaluation) const
{
    const double variance = noiseVariance(scalePx_);
    NormalEquations start;
    prior_.add(joint.first, variance, start);
    evaluation.equations.hessian.topLeftCorner<6, 6>() += Matrix6d(start.hessian.selfadjointView<Eigen::Lower>());
    evaluation.equations.gradient.head<6>() += start.gradient;
    evaluation.loss += variance * prior_.cost(joint.first);
    for (std::size_t k = 1; k < views_.size(); ++k) {
        const Vector6d weight = variance * correctionStd_[k].cwiseAbs2().cwiseInverse();
        const auto at = static_cast<Eigen::Index>(6 * k);
        evaluation.equations.hessian.block<6, 6>(at, at).diagonal() += weight;
        evaluation.equations.gradient.segment<6>(at) += weight.cwiseProduct(joint.corrections[k]);
        evaluation.loss += joint.corrections[k].dot(weight.cwiseProduct(joint.corrections[k]));
    }
}

/// Returns the scales from the widest to the final one.
std::vector<double> jointScalesPx()
{
    std::vector<double> scalesPx{jointStartScalePx};
    while (scalesPx.back() > jointEndScalePx) {
        scalesPx.push_back(std::max(jointEndScalePx, jointShrink * scalesPx.back()));
    }
    return scalesPx;
}

}   // namespace

JointView::JointView(RegistrationProblem given)
    : problem(std::move(given)),
      lines(problem.target, problem.camera),
      alignment(informativePoints(problem.tree, mmPerPx(problem)), problem.camera, lines),
      score(problem, lines)
{
}

JointSolver::JointSolver(const Views& views, const InitialPosePrior& prior, std::vector<Vector6d> correctionStd)
    : views_(views), prior_(prior), correctionStd_(std::move(correctionStd))
{
    const RigidTransform firstInverse = views.front()->problem.start.inverse();
    for (const auto& view : views) {
        geometry_.push_back({view->problem.start * firstInverse, view->problem.camera});
    }
}

CentroidPose JointSolver::toFirstView(const RigidTransform& pose, std::size_t view) const
{
    return aboutCentroid(geometry_[view].cameraFromFirst.inverse() * pose, views_.front()->problem.tree.centroid);
}

RigidTransform JointSolver::rotatedInitialPose(const RigidTransform& poseInFirst, std::size_t view) const
{
    const Eigen::Vector3d& centroid = views_.front()->problem.tree.centroid;
    CentroidPose rotated = aboutCentroid(views_[view]->problem.start, centroid);
    rotated.rotation = geometry_[view].cameraFromFirst.rotation * poseInFirst.rotation;
    return cameraFromPatient(rotated, centroid);
}

JointPose JointSolver::jointPoseFromViews(std::span<const RigidTransform> poses) const
{
    const Eigen::Vector3d& centroid = views_.front()->problem.tree.centroid;
    JointPose joint{aboutCentroid(poses.front(), centroid), std::vector<Vector6d>(views_.size(), Vector6d::Zero())};
    for (std::size_t k = 1; k < views_.size(); ++k) {
        joint.corrections[k] = stepBetween(inView(joint, k), aboutCentroid(poses[k], centroid));
    }
    return joint;
}

JointPose JointSolver::refine(const JointPose& start, const JointObserver& observe)
{
    for (const auto& view : views_) {
        view->alignment.resetVisibility();
    }
    JointAtScale problem(views_, geometry_, prior_, correctionStd_);
    EvaluationPair<JointEvaluation> evaluations;
    DampedDescent descent(problem, start, evaluations, {.minMotionMm = settledJointMm});
    const std::vector<double> scalesPx = jointScalesPx();
    for (std::size_t level = 0; level < scalesPx.size(); ++level) {
        problem.setScale(scalesPx[level]);
        descent.reevaluate();
        descent.resetDamping();
        const bool isLast = level + 1 == scalesPx.size();
        const StepOutcome last = descent.descend(isLast ? jointLastSteps : jointStepsPerScale, [&](const StepOutcome&) {
            const double done = static_cast<double>(level + 1) / static_cast<double>(scalesPx.size());
            return observe ? observe(descent.state(), problem.scalePx(), done) : ObserverDecision::Continue;
        });
        if (last.isStopped) {
            break;
        }
    }
    return descent.state();
}

double JointSolver::scoreOf(const JointPose& joint) const
{
    double sum = 0.0;
    for (std::size_t k = 0; k < views_.size(); ++k) {
        sum += views_[k]->score.scoreAt(inView(joint, k)) / static_cast<double>(views_.size());
    }
    return sum;
}

/// Returns the normal equations of pose, corrections and cameras in units of information, with the priors of the
/// corrections but without the prior of the initial pose.
StackedEquations JointSolver::equations(const JointPose& joint) const
{
    std::vector<CameraEquations> perView;
    for (std::size_t k = 0; k < views_.size(); ++k) {
        const CentroidPose pose = inView(joint, k);
        InitialPosePrior prior = prior_;
        prior.start = pose;
        perView.push_back(tolerantInformation(views_[k]->alignment, prior, pose, views_[k]->problem.cameraUncertainty));
    }
    StackedEquations all = stackEquations(perView, joint, geometry_);
    for (std::size_t k = 1; k < views_.size(); ++k) {
        const Vector6d weight = correctionStd_[k].cwiseAbs2().cwiseInverse();
        const auto at = static_cast<Eigen::Index>(6 * k);
        all.hessian.block<6, 6>(at, at).diagonal() += weight;
        all.gradient.segment<6>(at) += weight.cwiseProduct(joint.corrections[k]);
    }
    return all;
}

JointInformation JointSolver::jointInformation(const JointPose& joint) const
{
    StackedEquations all = equations(joint);
    const auto poses = static_cast<Eigen::Index>(6 * views_.size());
    const Eigen::Index others = poses - 6;
    const Eigen::MatrixXd towards = all.hessian.block(6, 0, others, 6);
    JointInformation jointInformation;
    jointInformation.information =
        all.hessian.topLeftCorner<6, 6>() -
        towards.transpose() * solveSymmetric(all.hessian.block(6, 6, others, others), towards);
    std::vector<CameraUncertainty> uncertainties;
    for (const auto& view : views_) {
        uncertainties.push_back(view->problem.cameraUncertainty);
    }
    NormalEquations start;
    prior_.add(joint.first, 1.0, start);
    all.hessian.topLeftCorner<6, 6>() += start.hessian;
    all.gradient.head<6>() += start.gradient;
    const CameraInfluence influence(all, Eigen::MatrixXd::Identity(poses, poses), uncertainties);
    jointInformation.cameraCovariance = influence.poseCovariance();
    const bool isAnyUncertain =
        std::ranges::any_of(uncertainties, [](const CameraUncertainty& each) { return !each.isExact(); });
    for (std::size_t k = 0; isAnyUncertain && k < views_.size(); ++k) {
        jointInformation.cameras.push_back(influence.evidence(k));
    }
    return jointInformation;
}

bool JointSolver::isPlausible(const JointPose& joint, std::size_t view) const
{
    return joint.corrections[view].cwiseQuotient(correctionStd_[view]).cwiseAbs().maxCoeff() < implausibleSigmas;
}

double JointSolver::correctionCost(const JointPose& joint) const
{
    double sum = 0.0;
    for (std::size_t k = 1; k < views_.size(); ++k) {
        sum += joint.corrections[k].cwiseQuotient(correctionStd_[k]).squaredNorm();
    }
    return sum;
}

bool JointSolver::isPlausible(const JointPose& joint) const
{
    for (std::size_t k = 1; k < views_.size(); ++k) {
        if (!isPlausible(joint, k)) {
            return false;
        }
    }
    return true;
}

double jointStepLengthMm(const Eigen::VectorXd& step, double spreadMm)
{
    double farthestMm = 0.0;
    for (Eigen::Index at = 0; at < step.size(); at += 6) {
        farthestMm = std::max(farthestMm, stepLengthMm(step.segment<6>(at), spreadMm));
    }
    return farthestMm;
}

}   // namespace angiopose::core
