#pragma once

#include "core/registration/pose/damped_step.h"
#include "core/registration/problem/registration_result.h"

#include <span>
#include <vector>

namespace angiopose::core {

/// What errors of the cameras do to a pose that is found as if the cameras were right, and what the images say about
/// such errors (ALGORITHMS §6.18).
class CameraInfluence {
public:
    /// `equations`: of the images and the priors of the pose, in units of information. Their parameters are those of
    /// the pose, then three of each camera (see CameraError), which err by `spreads`. `free`: steps that the pose may
    /// take, one column each.
    CameraInfluence(const StackedEquations& equations, const Eigen::MatrixXd& free,
                    std::span<const CameraSpread> spreads);

    /// What the cameras' errors add to the covariance of the first six parameters: the spread that the images leave of
    /// them, and the error that they show, which the pose does not take out.
    Matrix6d covarianceOfPose() const;

    /// What all images say about one camera.
    CameraEvidence evidence(std::size_t camera) const;

private:
    Eigen::MatrixXd shift_;   ///< of the pose's parameters for an error of 1 of each parameter of the cameras
    Eigen::VectorXd error_;   ///< most likely
    Eigen::MatrixXd left_;   ///< its covariance
    double gain_ = 0.0;
};

/// A camera that images contradict: by how much, in words. Nothing where they do not, or say too little.
Messages contradictionsOf(const CameraEvidence& evidence, const ProjectionCamera& camera, std::size_t cameras = 1);

}   // namespace angiopose::core
