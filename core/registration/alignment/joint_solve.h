#pragma once

#include "core/registration/alignment/agreement_score.h"
#include "core/registration/alignment/joint_alignment.h"
#include "core/registration/pose/damped_descent.h"

#include <functional>
#include <memory>

namespace angiopose::core {

/// Input of the joint solve for one view.
struct JointView {
    explicit JointView(RegistrationProblem given);

    RegistrationProblem problem;
    TargetLines lines;
    Alignment alignment;
    AgreementScore score;
};

/// Receives the current pose, the scale in px and the completed share, 0…1; Stop ends the refinement with the current
/// result.
using JointObserver = std::function<Verdict(const JointPose& joint, double scalePx, double progress)>;

/// Information of all images at a joint pose.
struct JointKnowledge {
    Matrix6d information;   ///< about the first pose, assuming exact cameras
    Matrix6d covarianceByCameras;   ///< covariance of the first pose caused by camera errors
    std::vector<CameraEvidence> cameras;   ///< one per view; empty if all cameras count as exact
};

/// Registers one tree to all views at once, starting from poses found in single views (ALGORITHMS §6.12).
class JointSolve {
public:
    using Views = std::vector<std::unique_ptr<JointView>>;

    /// Takes the geometry between the views from their initial poses; its 1-σ error is `correctionStd` per view (rad,
    /// mm).
    JointSolve(const Views& views, const StartPrior& prior, std::vector<Vector6d> correctionStd);

    /// Converts a pose found in view `view` to the first view.
    CentroidPose inFirst(const RigidTransform& pose, std::size_t view) const;

    /// Initial pose of a view, rotated to match a pose in the first view and the geometry.
    RigidTransform turnedLike(const RigidTransform& poseInFirst, std::size_t view) const;

    /// Joint pose that places every view at its own pose, whatever corrections of the geometry this requires.
    JointPose ofEach(std::span<const RigidTransform> poses) const;

    JointPose refine(const JointPose& start, const JointObserver& observe);

    /// Mean agreement of the views, 0…1.
    double scoreOf(const JointPose& joint) const;

    CentroidPose inView(const JointPose& joint, std::size_t view) const { return poseInView(joint, geometry_, view); }

    /// Information of all images about the first pose and the cameras, with the corrections of the geometry unknown
    /// within their standard deviations.
    JointKnowledge knowledge(const JointPose& joint) const;

    /// Sum of squares of all corrections in units of their σ.
    double contradiction(const JointPose& joint) const;

    /// Whether the correction of every view stays within 4 σ in all directions.
    bool isPlausible(const JointPose& joint) const;
    bool isPlausible(const JointPose& joint, std::size_t view) const;

    const StartPrior& prior() const { return prior_; }

private:
    StackedEquations equations(const JointPose& joint) const;

    const Views& views_;
    std::vector<PlacedCamera> geometry_;
    StartPrior prior_;
    std::vector<Vector6d> correctionStd_;   ///< one per view
};

/// Displacement caused by a step of all parameters, mm: the larger of the motion of the tree in the first view and the
/// additional motion by a correction in another.
double jointStepLengthMm(const Eigen::VectorXd& step, double spreadMm);

}   // namespace angiopose::core
