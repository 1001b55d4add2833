#include "core/registration/register_views.h"

#include "core/geometry/angle_units.h"
#include "core/messages/says.h"
#include "core/registration/alignment/camera_influence.h"
#include "core/registration/alignment/joint_solve.h"
#include "core/registration/bending_doubt.h"
#include "core/registration/judging/judge_pose.h"
#include "core/registration/judging/pose_uncertainty.h"
#include "core/registration/methods/method_info.h"
#include "core/registration/pose/tree_shift.h"
#include "core/registration/problem/in_view.h"
#include "core/registration/problem/method_solution.h"

namespace angiopose::core {
namespace {

constexpr double clearlyLess = 0.9;   // of the agreement that the views reach each by itself
constexpr double aloneShare = 0.9;   // of the progress of a view; the rest is its joint refinement

Result<JointSolve::Views> makeViews(std::span<const RegistrationInput> inputs, const RegistrationOptions& options,
                                    const MultiViewOptions& multiView)
{
    if (inputs.size() < 2) {
        return Error(says::viewsTooFew());
    }
    if (isAnyLocked(options.locks)) {
        return Error(says::viewsCannotLock());
    }
    JointSolve::Views views;
    for (std::size_t k = 0; k < inputs.size(); ++k) {
        auto problem = makeProblem(inputs[k], options);
        if (!problem) {
            return inView(multiView.numberOf(k), problem.error());
        }
        views.push_back(std::make_unique<JointView>(std::move(problem).value()));
        const TreeSamples& tree = views.back()->problem.tree;
        const TreeSamples& firstTree = views.front()->problem.tree;
        if (tree.size() != firstTree.size() || (tree.centroid - firstTree.centroid).norm() > 1e-6) {
            return Error(says::viewsOfOtherTree(multiView.numberOf(k), multiView.numberOf(0)));
        }
    }
    return views;
}

/// Carries the reports of the single runs and of the joint refinements to the observer, as parts of the whole: their
/// numbers and their progress never fall. Once the answer was Stop it stays Stop.
class JointProgress {
public:
    JointProgress(const JointView& first, std::size_t viewCount, const IterationObserver& observe)
        : first_(first), shift_(first.problem.tree.points), viewCount_(viewCount), observe_(observe)
    {
    }

    /// From a registration of one view: of its own pose.
    Verdict report(std::size_t view, IterationReport report)
    {
        report.view = view;
        report.progress *= aloneShare;
        last_.reset();
        return pass(view, std::move(report));
    }

    /// From the joint refinement of a start of a view's: of the pose in the first view; `done` of all its starts.
    Verdict report(std::size_t view, const JointPose& joint, double scalePx, double done)
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

    /// Asks whether to go on while the poses rest.
    Verdict askAgain(std::string_view stage)
    {
        told_.stage = stage;
        isStopped_ = isStopped_ || (observe_ && iterations_ > 0 && observe_(told_) == Verdict::Stop);
        return isStopped_ ? Verdict::Stop : Verdict::Continue;
    }

    bool isStopped() const { return isStopped_; }

private:
    Verdict pass(std::size_t view, IterationReport report)
    {
        report.iteration = ++iterations_;
        report.progress = (static_cast<double>(view) + report.progress) / static_cast<double>(viewCount_);
        told_ = report;
        isStopped_ = isStopped_ || (observe_ && observe_(report) == Verdict::Stop);
        return isStopped_ ? Verdict::Stop : Verdict::Continue;
    }

    const JointView& first_;
    TreeShift shift_;
    std::optional<RigidTransform> last_;   ///< of the joint report before
    std::size_t viewCount_;
    const IterationObserver& observe_;
    std::vector<double> distances_;
    IterationReport told_;   ///< the last one
    int iterations_ = 0;
    bool isStopped_ = false;
};

/// Poses that one view explains: its answer and the others nearly as good.
std::vector<RigidTransform> posesOf(const RegistrationResult& alone)
{
    std::vector<RigidTransform> poses{alone.cameraFromPatient};
    for (const Hypothesis& other : alone.alternatives) {
        poses.push_back(other.cameraFromPatient);
    }
    return poses;
}

/// Where the geometry is wrong no view's answer fits the others: how they contradict shows with each at its own.
JointPose refinedAtItsOwn(JointSolve& solve, const JointPose& each, std::size_t lastView, JointProgress& progress)
{
    return solve.refine(each, [&](const JointPose& reached, double scalePx, double) {
        return progress.report(lastView, reached, scalePx, 1.0);
    });
}

/// Every view's own answers, carried to the first view, are where the joint solve starts from; the best score wins.
Result<JointPose> bestJointPose(JointSolve& solve, std::span<const RegistrationInput> inputs,
                                const RegistrationOptions& options, const MultiViewOptions& multiView,
                                JointProgress& progress)
{
    JointPose best{solve.inFirst(inputs.front().initialCameraFromPatient, 0),
                   std::vector<Vector6d>(inputs.size(), Vector6d::Zero())};
    double bestScore = -1.0;
    std::vector<RigidTransform> aloneBest;
    RegistrationOptions ofOneView = options;
    ofOneView.geometry.otherFrames = false;   // all views together tell
    ofOneView.bending = Bending::Off;
    for (std::size_t k = 0; k < inputs.size() && !progress.isStopped(); ++k) {
        const auto alone = registerVessels(inputs[k], ofOneView,
                                           [&](const IterationReport& report) { return progress.report(k, report); });
        if (!alone) {
            return inView(multiView.numberOf(k), alone.error());
        }
        aloneBest.push_back(alone.value().cameraFromPatient);
        const std::vector<RigidTransform> starts = posesOf(alone.value());
        for (std::size_t i = 0; i < starts.size(); ++i) {
            const JointPose joint =
                solve.refine(solve.inFirst(starts[i], k), [&](const JointPose& reached, double scalePx, double done) {
                    const double share = (static_cast<double>(i) + done) / static_cast<double>(starts.size());
                    return progress.report(k, reached, scalePx, share);
                });
            if (const double score = solve.scoreOf(joint); score > bestScore) {
                best = joint;
                bestScore = score;
            }
        }
    }
    if (aloneBest.size() == inputs.size() && !progress.isStopped()) {
        const JointPose each = solve.ofEach(aloneBest);
        if (bestScore < clearlyLess * solve.scoreOf(each)) {
            best = refinedAtItsOwn(solve, each, inputs.size() - 1, progress);
        }
    }
    return best;
}

/// Judges one view at the joint pose; what speaks against it is added to the result's warnings.
void addView(MultiViewResult& result, std::size_t number, const JointView& view, MethodSolution solution,
             bool isPlausible, const RegistrationOptions& options)
{
    result.views.push_back(judgePose(view.problem, options, solution));
    result.views.back().method = options.method;
    if (!result.views.back().trustworthy) {
        result.trustworthy = false;
        result.warnings.push_back(says::viewDisagrees(number));
    }
    if (!isPlausible) {
        result.trustworthy = false;
        result.warnings.push_back(says::viewFarFromHeader(number));
    }
}

bool isBendAsked(const JointSolve::Views& views, const RegistrationOptions& options, const MultiViewResult& result)
{
    if (options.bending != Bending::Auto || options.method != methodInfos().front().id) {
        return options.bending == Bending::Always;
    }
    for (std::size_t k = 0; k < views.size(); ++k) {
        if (looksBent({views[k]->problem, views[k]->lines, result.views[k].cameraFromPatient})) {
            return true;
        }
    }
    return false;
}

/// All views together tell how the vessels are bent. The geometry between them is that of the start poses: what
/// corrected it for a rigid tree may have been the bend.
void hearBending(MultiViewResult& result, std::span<const RegistrationInput> inputs, const RegistrationOptions& options,
                 const MultiViewOptions& multiView, JointProgress& progress)
{
    std::vector<DeformableView> views;
    const RigidTransform fromStart =
        inputs.front().initialCameraFromPatient.inverse() * result.views.front().cameraFromPatient;
    for (std::size_t k = 0; k < inputs.size(); ++k) {
        views.push_back({inputs[k], inputs[k].initialCameraFromPatient * fromStart, multiView.numberOf(k)});
    }
    DeformableOptions bending = bendingOptions(options);
    bending.geometryDeg = multiView.relativeRotationStdDeg;
    bending.geometryMm = multiView.relativeShiftStdMm;
    result.bent = judgeByBending(views, bending, {result.uncertainty, result.trustworthy, result.warnings},
                                 [&](const IterationReport&) { return progress.askAgain("bending"); });
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
    Vector6d correctionStd;
    correctionStd.head<3>().setConstant(multiView.relativeRotationStdDeg / degreesPerRadian);
    correctionStd.tail<3>().setConstant(multiView.relativeShiftStdMm);
    JointSolve solve(views, startPrior(aboutCentroid(first.start, first.tree.centroid), options), correctionStd);
    JointProgress progress(*views.front(), views.size(), observe);
    const auto best = bestJointPose(solve, inputs, options, multiView, progress);
    if (!best) {
        return best.error();
    }

    const JointPose& pose = best.value();
    MultiViewResult result;
    result.corrections = pose.corrections;
    const JointKnowledge knowledge = solve.knowledge(pose);
    result.uncertainty =
        poseUncertainty(first, knowledge.information, knowledge.covarianceByCameras, solve.prior(), pose.first);
    result.cameras = knowledge.cameras;
    result.trustworthy = true;
    for (std::size_t k = 0; k < views.size(); ++k) {
        MethodSolution solution;
        solution.cameraFromPatient = cameraFromPatient(solve.inView(pose, k), views[k]->problem.tree.centroid);
        solution.stopReason = progress.isStopped() ? StopReason::StoppedByUser : StopReason::Converged;
        addView(result, multiView.numberOf(k), *views[k], std::move(solution), solve.isPlausible(pose.corrections[k]),
                options);
    }
    for (std::size_t k = 0; k < result.cameras.size(); ++k) {
        for (const Message& said : contradictionsOf(result.cameras[k], views[k]->problem.camera, views.size())) {
            result.warnings.push_back(says::inView(multiView.numberOf(k), said));
        }
    }
    if (!progress.isStopped() && isBendAsked(views, options, result)) {
        hearBending(result, inputs, options, multiView, progress);
    }
    return result;
}

}   // namespace angiopose::core