#include "core/registration/register_views.h"

#include "core/geometry/angle_units.h"
#include "core/messages/messages.h"
#include "core/registration/alignment/camera_influence.h"
#include "core/registration/alignment/joint_solver.h"
#include "core/registration/deformation_check.h"
#include "core/registration/judging/assess_pose.h"
#include "core/registration/judging/pose_uncertainty.h"
#include "core/registration/methods/method_info.h"
#include "core/registration/pose/tree_shift.h"
#include "core/registration/problem/in_view.h"
#include "core/registration/problem/method_solution.h"

#include <algorithm>
#include <utility>

namespace angiopose::core {
namespace {

constexpr double clearlyLess = 0.9;   // minimum agreement of the joint pose, relative to the individual poses
constexpr double knownTurnReachDeg = 3.0;   // search range in a view whose rotation is known from another view
constexpr std::size_t maxSearchedAgain = 3;
constexpr double widestForDeformationMm =
    8.0;   // maximum shift uncertainty between views for deformation; larger corrections have other causes
constexpr double aloneShare = 0.9;   // fraction of a view's progress spent before its joint refinement

Result<JointSolver::Views> makeViews(std::span<const RegistrationInput> inputs, const RegistrationOptions& options,
                                     const MultiViewOptions& multiView)
{
    if (inputs.size() < 2) {
        return Error(messages::viewsTooFew());
    }
    if (isAnyLocked(options.locks)) {
        return Error(messages::viewsCannotLock());
    }
    JointSolver::Views views;
    for (std::size_t k = 0; k < inputs.size(); ++k) {
        auto problem = makeProblem(inputs[k], options);
        if (!problem) {
            return inView(multiView.viewNumber(k), problem.error());
        }
        views.push_back(std::make_unique<JointView>(std::move(problem).value()));
        const TreeSamples& tree = views.back()->problem.tree;
        const TreeSamples& firstTree = views.front()->problem.tree;
        if (tree.size() != firstTree.size() || (tree.centroid - firstTree.centroid).norm() > 1e-6) {
            return Error(messages::viewsOfOtherTree(multiView.viewNumber(k), multiView.viewNumber(0)));
        }
    }
    return views;
}

/// Forwards the reports of the single-view registrations and the joint refinements to the observer as parts of the
/// whole: iteration numbers and progress never decrease. Once the observer has returned Stop, the result remains Stop.
class JointProgress {
public:
    JointProgress(const JointView& first, std::size_t viewCount, const IterationObserver& observe)
        : first_(first), shift_(first.problem.tree.points), viewCount_(viewCount), observe_(observe)
    {
    }

    /// Forwards a report of a single-view registration, with the pose in that view.
    ObserverDecision report(std::size_t view, IterationReport report)
    {
        report.view = view;
        report.progress *= aloneShare;
        last_.reset();
        return pass(view, std::move(report));
    }

    /// Forwards a report of a joint refinement that started from a pose of `view`, with the pose in the first view;
    /// `done` is the completed fraction over all starting poses of that view.
    ObserverDecision report(std::size_t view, const JointPose& joint, double scalePx, double done)
    {
        IterationReport report;
        report.stage = "joint";
        report.scalePx = scalePx;
        report.medianDistancePx = first_.alignment.medianDistancePx(joint.first, distances_);
        report.progress = aloneShare + (1.0 - aloneShare) * done;
        report.cameraFromPatient = cameraFromPatient(joint.first, first_.problem.tree.centroid);
        report.stepMm = last_ ? shift_.rmsMm(*last_, report.cameraFromPatient) : 0.0;
        last_ = report.cameraFromPatient;
        return pass(view, std::move(report));
    }

    /// Checks for a stop request while the poses are unchanged.
    ObserverDecision checkForStop(std::string_view stage)
    {
        reported_.stage = stage;
        isStopped_ = isStopped_ || (observe_ && iterations_ > 0 && observe_(reported_) == ObserverDecision::Stop);
        return isStopped_ ? ObserverDecision::Stop : ObserverDecision::Continue;
    }

    bool isStopped() const { return isStopped_; }

private:
    ObserverDecision pass(std::size_t view, IterationReport report)
    {
        report.iteration = ++iterations_;
        report.progress = std::max(reported_.progress,
                                   (static_cast<double>(view) + report.progress) / static_cast<double>(viewCount_));
        reported_ = report;
        isStopped_ = isStopped_ || (observe_ && observe_(report) == ObserverDecision::Stop);
        return isStopped_ ? ObserverDecision::Stop : ObserverDecision::Continue;
    }

    const JointView& first_;
    TreeShift shift_;
    std::optional<RigidTransform> last_;   ///< pose of the previous report of a joint refinement
    std::size_t viewCount_;
    const IterationObserver& observe_;
    std::vector<double> distances_;
    IterationReport reported_;   ///< last report forwarded
    int iterations_ = 0;
    bool isStopped_ = false;
};

/// Returns the poses that explain one view: its result and the nearly equally good alternatives.
std::vector<RigidTransform> posesOf(const RegistrationResult& alone)
{
    std::vector<RigidTransform> poses{alone.cameraFromPatient};
    for (const Hypothesis& other : alone.alternatives) {
        poses.push_back(other.cameraFromPatient);
    }
    return poses;
}

struct BestJoint {
    JointPose pose;
    double score = -1.0;

    void offer(const JointSolver& solve, const JointPose& joint)
    {
        if (const double reached = solve.scoreOf(joint); reached > score) {
            pose = joint;
            score = reached;
        }
    }
};

/// Combines one pose of a view with those poses of the other views that contradict the geometry least.
JointPose combineWithOtherViews(const JointSolver& solve, const std::vector<std::vector<RigidTransform>>& poses,
                                std::size_t view, const RigidTransform& pose)
{
    std::vector<RigidTransform> chosen;
    for (const auto& each : poses) {
        chosen.push_back(each.front());
    }
    chosen[view] = pose;
    JointPose best = solve.jointPoseFromViews(chosen);
    for (std::size_t k = 0; k < poses.size(); ++k) {
        for (std::size_t i = 0; k != view && i < poses[k].size(); ++i) {
            std::vector<RigidTransform> changed = chosen;
            changed[k] = poses[k][i];
            const JointPose joint = solve.jointPoseFromViews(changed);
            if (solve.correctionCost(joint) < solve.correctionCost(best)) {
                chosen = std::move(changed);
                best = joint;
            }
        }
    }
    return best;
}

/// Finds the joint pose from the poses of single views.
class JointSearch {
public:
    JointSearch(JointSolver& solve, std::span<const RegistrationInput> inputs, const RegistrationOptions& options,
                const MultiViewOptions& multiView, JointProgress& progress)
        : solve_(solve), inputs_(inputs), ofOneView_(options), multiView_(multiView), progress_(progress)
    {
        ofOneView_.geometry.checkOrientation = false;   // to be decided from all views together
        ofOneView_.deformation = Deformation::Off;
        best_.pose = {solve.toFirstView(inputs.front().initialCameraFromPatient, 0),
                      std::vector<Vector6d>(inputs.size(), Vector6d::Zero())};
        for (std::size_t k = 1; k < inputs.size(); ++k) {
            predictsPosition_ = predictsPosition_ && multiView.relativePoseStd(k).predictsPosition();
            isTight_ =
                isTight_ && multiView.relativePoseStd(k).shiftMm.maxCoeff() <= RelativePoseStd().shiftMm.maxCoeff();
        }
    }

    Result<JointPose> find()
    {
        for (std::size_t k = 0; k < inputs_.size() && !progress_.isStopped(); ++k) {
            auto alone = singleViewPoses(k, inputs_[k], ofOneView_);
            if (!alone) {
                return alone.error();
            }
            poses_.push_back(std::move(alone).value());
            if (predictsPosition_ || best_.score < 0.0) {   // otherwise the first pose is the result of an early stop
                refineFrom(k);
            }
        }
        if (poses_.size() < inputs_.size() || progress_.isStopped()) {
            return best_.pose;
        }
        if (!predictsPosition_) {
            best_.score = -1.0;
        }
        if (!isTight_) {
            refineTogether();
        }
        if (!predictsPosition_ && best_.score < 0.0) {
            if (const auto again = searchWithKnownRotation(); !again) {
                return again.error();
            }
            refineTogether();
        }
        return bestOrIndependentPoses();
    }

private:
    /// Registers a single view and returns its result and the nearly equally good alternatives.
    Result<std::vector<RigidTransform>> singleViewPoses(std::size_t view, const RegistrationInput& input,
                                                        const RegistrationOptions& options)
    {
        const auto alone = registerVessels(
            input, options, [&](const IterationReport& report) { return progress_.report(view, report); });
        if (!alone) {
            return inView(multiView_.viewNumber(view), alone.error());
        }
        return posesOf(alone.value());
    }

    JointPose refined(const JointPose& start, std::size_t view, double first, double share)
    {
        return solve_.refine(start, [&](const JointPose& reached, double scalePx, double done) {
            return progress_.report(view, reached, scalePx, first + share * done);
        });
    }

    /// Refines jointly from each pose of a view, transformed to the first view.
    void refineFrom(std::size_t view)
    {
        const double share = 1.0 / static_cast<double>(poses_[view].size());
        for (std::size_t i = 0; i < poses_[view].size(); ++i) {
            const JointPose start{solve_.toFirstView(poses_[view][i], view),
                                  std::vector<Vector6d>(inputs_.size(), Vector6d::Zero())};
            best_.offer(solve_, refined(start, view, share * static_cast<double>(i), share));
        }
    }

    /// Refines jointly from the separate poses of the views, as far as the relative geometry allows. Needed if the
    /// geometry is uncertain, because the pose of one view then does not fit the image of another.
    void refineTogether()
    {
        for (std::size_t view = 0; view < poses_.size(); ++view) {
            for (const RigidTransform& pose : poses_[view]) {
                const JointPose joint = combineWithOtherViews(solve_, poses_, view, pose);
                if (solve_.isPlausible(joint) && !progress_.isStopped()) {
                    best_.offer(solve_, refined(joint, inputs_.size() - 1, 1.0, 0.0));
                }
            }
        }
    }

    /// Searches the other views again, starting with the rotation implied by each pose of the first view. Needed if no
    /// combination of poses agrees with the gantry rotation.
    Status searchWithKnownRotation()
    {
        RegistrationOptions turned = ofOneView_;
        turned.angiopose.searchTiltDeg = turned.angiopose.searchRollDeg = knownTurnReachDeg;
        const std::vector<RigidTransform> ofFirst = poses_.front();
        for (std::size_t k = 1; k < inputs_.size(); ++k) {
            turned.angiopose.priorRotationDeg = multiView_.relativePoseStd(k).rotationDeg;
            for (std::size_t i = 0; i < std::min(ofFirst.size(), maxSearchedAgain) && !progress_.isStopped(); ++i) {
                RegistrationInput input = inputs_[k];
                input.initialCameraFromPatient = solve_.rotatedInitialPose(ofFirst[i], k);
                auto found = singleViewPoses(k, input, turned);
                if (!found) {
                    return found.error();
                }
                poses_[k].insert(poses_[k].end(), found.value().begin(), found.value().end());
            }
        }
        return Done{};
    }

    /// Returns the best joint pose or, if it fits clearly better, the joint pose that combines the separate poses of
    /// the views. The geometry is then wrong, as the large corrections show.
    JointPose bestOrIndependentPoses()
    {
        std::vector<RigidTransform> own;
        for (const auto& each : poses_) {
            own.push_back(each.front());
        }
        const JointPose each = solve_.jointPoseFromViews(own);
        return best_.score < clearlyLess * solve_.scoreOf(each) ? refined(each, inputs_.size() - 1, 1.0, 0.0)
                                                                : best_.pose;
    }

    JointSolver& solve_;
    std::span<const RegistrationInput> inputs_;
    RegistrationOptions ofOneView_;
    const MultiViewOptions& multiView_;
    JointProgress& progress_;
    bool predictsPosition_ = true;   ///< whether RelativePoseStd::predictsPosition holds for all views
    bool isTight_ = true;   ///< whether the relative geometry is as accurate as for simultaneous acquisition
    std::vector<std::vector<RigidTransform>> poses_;   ///< poses that explain each view
    BestJoint best_;
};

/// Assesses one view at the joint pose and adds any problems found to the warnings of the result.
void addView(MultiViewResult& result, std::size_t number, const JointView& view, MethodSolution solution,
             bool isPlausible, const RegistrationOptions& options)
{
    result.views.push_back(assessPose(view.problem, options, solution));
    result.views.back().method = options.method;
    if (!result.views.back().trustworthy) {
        result.trustworthy = false;
        result.warnings.push_back(messages::viewInconsistent(number));
    }
    if (!isPlausible) {
        result.trustworthy = false;
        result.warnings.push_back(messages::viewFarFromHeader(number));
    }
}

bool isDeformationRequested(const JointSolver::Views& views, const RegistrationOptions& options,
                            const MultiViewResult& result)
{
    if (options.deformation != Deformation::Auto || options.method != methodInfos().front().id) {
        return options.deformation == Deformation::Always;
    }
    for (std::size_t k = 0; k < views.size(); ++k) {
        if (looksDeformed({views[k]->problem, views[k]->lines, result.views[k].cameraFromPatient})) {
            return true;
        }
    }
    return false;
}

/// Determines the deformation jointly from all views. Uses the relative geometry of the initial poses, because
/// corrections found for a rigid tree may be an effect of the deformation.
void assessDeformation(MultiViewResult& result, std::span<const RegistrationInput> inputs,
                       const RegistrationOptions& options, const MultiViewOptions& multiView, JointProgress& progress)
{
    std::vector<DeformableView> views;
    DeformableOptions deformation = deformationOptions(options);
    const RigidTransform fromStart =
        inputs.front().initialCameraFromPatient.inverse() * result.views.front().cameraFromPatient;
    for (std::size_t k = 0; k < inputs.size(); ++k) {
        const RelativePoseStd spread = multiView.relativePoseStd(k);
        const bool isKnownFromHeader = spread.shiftMm.maxCoeff() <= RelativePoseStd().shiftMm.maxCoeff();
        const RigidTransform& found = result.views[k].cameraFromPatient;
        views.push_back({inputs[k], isKnownFromHeader ? inputs[k].initialCameraFromPatient * fromStart : found,
                         multiView.viewNumber(k)});
        deformation.geometryDeg = std::max(deformation.geometryDeg, spread.rotationDeg);
        deformation.geometryMm =
            std::max(deformation.geometryMm, std::min(spread.shiftMm.maxCoeff(), widestForDeformationMm));
    }
    result.deformed = deformAndAssess(views, deformation, {result.uncertainty, result.trustworthy, result.warnings},
                                      [&](const IterationReport&) { return progress.checkForStop("bending"); });
    for (RegistrationResult& view : result.views) {
        view.stopReason = progress.isStopped() ? StopReason::StoppedByUser : view.stopReason;
    }
}

}   // namespace

Result<MultiViewResult> registerViews(std::span<const RegistrationInput> inputs, const RegistrationOptions& options,
                                      const MultiViewOptions& multiView, const IterationObserver& observe)
{
    auto made = makeViews(inputs, options, multiView);
    if (!made) {
        return made.error();
    }
    const auto& views = made.value();
    const RegistrationProblem& first = views.front()->problem;
    std::vector<Vector6d> correctionStd(views.size());
    for (std::size_t k = 0; k < views.size(); ++k) {
        const RelativePoseStd spread = multiView.relativePoseStd(k);
        correctionStd[k] << Eigen::Vector3d::Constant(spread.rotationDeg / degreesPerRadian), spread.shiftMm;
    }
    JointSolver solve(views, initialPosePrior(aboutCentroid(first.start, first.tree.centroid), options),
                      std::move(correctionStd));
    JointProgress progress(*views.front(), views.size(), observe);
    const auto best = JointSearch(solve, inputs, options, multiView, progress).find();
    if (!best) {
        return best.error();
    }

    const JointPose& pose = best.value();
    MultiViewResult result;
    result.corrections = pose.corrections;
    const JointInformation jointInformation = solve.jointInformation(pose);
    result.uncertainty = poseUncertainty(first, jointInformation.information, jointInformation.cameraCovariance,
                                         solve.prior(), pose.first);
    result.cameras = jointInformation.cameras;
    result.trustworthy = true;
    for (std::size_t k = 0; k < views.size(); ++k) {
        MethodSolution solution;
        solution.cameraFromPatient = cameraFromPatient(solve.inView(pose, k), views[k]->problem.tree.centroid);
        solution.stopReason = progress.isStopped() ? StopReason::StoppedByUser : StopReason::Converged;
        addView(result, multiView.viewNumber(k), *views[k], std::move(solution), k == 0 || solve.isPlausible(pose, k),
                options);
    }
    for (std::size_t k = 0; k < result.cameras.size(); ++k) {
        for (const Message& said : contradictionsOf(result.cameras[k], views[k]->problem.camera, views.size())) {
            result.warnings.push_back(messages::inView(multiView.viewNumber(k), said));
        }
    }
    if (!progress.isStopped() && isDeformationRequested(views, options, result)) {
        assessDeformation(result, inputs, options, multiView, progress);
    }
    return result;
}

}   // namespace angiopose::core
