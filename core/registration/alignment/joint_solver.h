#pragma once

#include "core/registration/alignment/agreement_score.h"
#include "core/registration/alignment/joint_alignment.h"
#include "core/registration/pose/damped_descent.h"

#include <functional>
#include <memory>

namespace angiopose::core {

/// Input of the joint solver for one view.
struct JointView {
    explicit JointView(RegistrationProblem given);

    RegistrationProblem problem;
    TargetLines lines;
    Alignment alignment;
    AgreementScore score;
};

/// Receives the current pose, the scale in px and the completed fraction, 0…1; Stop ends the refinement at this pose.
using JointObserver = std::function<ObserverDecision(const JointPose& joint, double scalePx, double progress)>;

/// Information that all images together provide at a joint pose.
struct JointInformation {
    Matrix6d information;   ///< information about the first view's pose, assuming exact cameras
    Matrix6d cameraCovariance;   ///< contribution of camera errors to the covariance of the first view's pose
    std::vector<CameraEvidence> cameras;   ///< one per view; empty if all cameras are treated as exact
};

/// Registers one tree to all views jointly, starting from single-view poses (ALGORITHMS §6.12).
class JointSolver {
public:
    using Views = std::vector<std::unique_ptr<JointView>>;

    /// Derives the relative geometry of the views from their initial poses; `correctionStd` is the 1-σ error of this
    /// geometry per view (rad, mm).
    JointSolver(const Views& views, const InitialPosePrior& prior, std::vector<Vector6d> correctionStd);

    /// Transforms a pose in view `view` to the first view.
    CentroidPose toFirstView(const RigidTransform& pose, std::size_t view) const;

    /// Returns the initial pose of a view, rotated to agree with a pose in the first view and the relative geometry.
    RigidTransform rotatedInitialPose(const RigidTransform& poseInFirst, std::size_t view) const;

    /// Returns the joint pose in which every view has the given pose, regardless of how large the corrections become.
    JointPose jointPoseFromViews(std::span<const RigidTransform> poses) const;

    JointPose refine(const JointPose& start, const JointObserver& observe);

    /// Returns the mean agreement over the views, 0…1.
    double scoreOf(const JointPose& joint) const;

    CentroidPose inView(const JointPose& joint, std::size_t view) const { return poseInView(joint, geometry_, view); }

    /// Returns the information that all images provide about the first view's pose and the cameras; the geometry
    /// corrections are marginalized with their standard deviations.
    JointInformation jointInformation(const JointPose& joint) const;

    /// Returns the sum of squares of all corrections in units of σ.
    double correctionCost(const JointPose& joint) const;

    /// Whether every correction stays within 4 σ in all directions.
    bool isPlausible(const JointPose& joint) const;
    bool isPlausible(const JointPose& joint, std::size_t view) const;

    const InitialPosePrior& prior() const { return prior_; }

private:
    StackedEquations equations(const JointPose& joint) const;

    const Views& views_;
    std::vector<RelativeCamera> geometry_;
    InitialPosePrior prior_;
    std::vector<Vector6d> correctionStd_;   ///< one per view
};

/// Returns the displacement caused by a step in all parameters, mm: the motion of the tree in the first view or the
/// additional motion that a correction causes in another view, whichever is larger.
double jointStepLengthMm(const Eigen::VectorXd& step, double spreadMm);

}   // namespace angiopose::core
