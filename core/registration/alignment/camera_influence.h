#pragma once

#include "core/registration/pose/damped_step.h"
#include "core/registration/problem/registration_result.h"

#include <span>
#include <vector>

namespace angiopose::core {

/// Propagates camera errors to a pose that was registered with an exact camera model, and estimates these errors from
/// the images (ALGORITHMS §6.18).
class CameraInfluence {
public:
    /// `equations` combines images and pose priors in units of information. Its parameters are those of the pose,
    /// followed by three per camera (see CameraError) with standard deviations `spreads`. Each column of `free` is an
    /// allowed pose step.
    CameraInfluence(const StackedEquations& equations, const Eigen::MatrixXd& free,
                    std::span<const CameraUncertainty> uncertainties);

    /// Returns the contribution of the camera errors to the covariance of the first six parameters: the spread that the
    /// images leave undetermined, plus the detected error that the pose does not compensate.
    Matrix6d poseCovariance() const;

    /// Returns the evidence of all images about one camera.
    CameraEvidence evidence(std::size_t camera) const;

private:
    Eigen::MatrixXd shift_;   ///< change of the pose per unit of each camera parameter
    Eigen::VectorXd error_;   ///< maximum a posteriori camera errors
    Eigen::MatrixXd posteriorCovariance_;   ///< posterior covariance of the camera errors
    double gain_ = 0.0;
};

/// Returns messages that state by how much the images contradict a camera; none if they agree with it or if the
/// evidence is too weak.
Messages contradictionsOf(const CameraEvidence& evidence, const ProjectionCamera& camera, std::size_t cameras = 1);

}   // namespace angiopose::core
