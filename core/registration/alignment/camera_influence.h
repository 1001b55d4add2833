#pragma once

#include "core/registration/pose/damped_step.h"
#include "core/registration/problem/registration_result.h"

#include <span>
#include <vector>

namespace angiopose::core {

/// Effect of camera errors on a pose that was registered assuming exact cameras, and the evidence of the images for
/// such errors (ALGORITHMS §6.18).
class CameraInfluence {
public:
    /// `equations` are those of the images and the pose priors, in units of information. Their parameters are those of
    /// the pose, followed by three per camera (see CameraError) with standard deviations `spreads`. `free` holds the
    /// allowed pose steps, one per column.
    CameraInfluence(const StackedEquations& equations, const Eigen::MatrixXd& free,
                    std::span<const CameraSpread> spreads);

    /// Contribution of the camera errors to the covariance of the first six parameters: the spread that the images
    /// leave undetermined, plus the detected error that the pose does not compensate.
    Matrix6d covarianceOfPose() const;

    /// Evidence of all images about one camera.
    CameraEvidence evidence(std::size_t camera) const;

private:
    Eigen::MatrixXd shift_;   ///< change of the pose parameters per unit of each camera parameter
    Eigen::VectorXd error_;   ///< most likely camera errors
    Eigen::MatrixXd left_;   ///< covariance of the camera errors
    double gain_ = 0.0;
};

/// Messages that describe by how much the images contradict a camera; empty where they do not or where the evidence is
/// too weak.
Messages contradictionsOf(const CameraEvidence& evidence, const ProjectionCamera& camera, std::size_t cameras = 1);

}   // namespace angiopose::core
