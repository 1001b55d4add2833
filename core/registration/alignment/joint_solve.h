#pragma once

#include "core/registration/alignment/agreement_score.h"
#include "core/registration/alignment/joint_alignment.h"
#include "core/registration/pose/damped_descent.h"

#include <functional>
#include <memory>

namespace angiopose::core {

/// One view as the joint solve needs it.
struct JointView {
    explicit JointView(RegistrationProblem given);

    RegistrationProblem problem;
    TargetLines lines;
    Alignment alignment;
    AgreementScore score;
};

/// Told the pose so far, the scale in px and the share done, 0…1; Stop ends the refinement with what it has.
using JointObserver = std::function<Verdict(const JointPose& joint, double scalePx, double progress)>;

/// What all images tell at a joint pose.
struct JointKnowledge {
    Matrix6d information;   ///< about the first pose, where the cameras are right
    Matrix6d covarianceByCameras;   ///< of the first pose
    std::vector<CameraEvidence> cameras;   ///< one per view; empty: all cameras count as exact
};

/// Registers one tree to all views at once, from poses found in single views (ALGORITHMS §6.12).
class JointSolve {
public:
    using Views = std::vector<std::unique_ptr<JointView>>;

    /// Geometry between the views from their start poses, off by `correctionStd` of each (rad, mm) at 1-σ.
    JointSolve(const Views& views, const StartPrior& prior, std::vector<Vector6d> correctionStd);

    /// Pose in the first view that a pose found in view `view` means.
    CentroidPose inFirst(const RigidTransform& pose, std::size_t view) const;

    /// The start of a view, turned as a pose in the first view and the geometry say.
    RigidTransform turnedLike(const RigidTransform& poseInFirst, std::size_t view) const;

    /// Every view at a pose of its own, whatever that asks of the geometry between them.
    JointPose ofEach(std::span<const RigidTransform> poses) const;

    JointPose refine(const JointPose& start, const JointObserver& observe);

    /// Mean agreement of the views, 0…1.
    double scoreOf(const JointPose& joint) const;

    CentroidPose inView(const JointPose& joint, std::size_t view) const { return poseInView(joint, geometry_, view); }

    /// Of all images about the first pose, the corrections of the geometry being unknown within their spread, and of
    /// the cameras.
    JointKnowledge knowledge(const JointPose& joint) const;

    /// Sum over all corrections, in squares of their σ.
    double contradiction(const JointPose& joint) const;

    /// The correction of every view in no direction farther than 4 σ.
    bool isPlausible(const JointPose& joint) const;
    bool isPlausible(const JointPose& joint, std::size_t view) const;

    const StartPrior& prior() const { return prior_; }

private:
    StackedEquations equations(const JointPose& joint) const;

    const Views& views_;
    std::vector<PlacedCamera> geometry_;
    StartPrior prior_;
    std::vector<Vector6d> correctionStd_;   ///< of each view
};

/// What a step of all parameters moves, mm: the tree in the first view, or what a correction adds in another,
/// whichever is farther.
double jointStepLengthMm(const Eigen::VectorXd& step, double spreadMm);

}   // namespace angiopose::core
