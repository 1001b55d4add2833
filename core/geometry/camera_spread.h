#pragma once

#include "core/geometry/c_arm.h"

namespace angiopose::core {

/// Error of a camera: logarithm of the focal length (true over assumed), then cx and cy in px (true less assumed).
using CameraError = Eigen::Vector3d;

/// How far a camera may be from the true one, 1-σ (ALGORITHMS §5.8). All zero: it is taken to be exact.
struct CameraSpread {
    double focalShare = 0.0;   ///< of fx and fy, which err together: of the distance, and of the size of a pixel
    double principalPx = 0.0;   ///< of cx and of cy, each
    CameraError taken =
        CameraError::Zero();   ///< by which the camera was corrected already: what it is about lies there

    bool operator==(const CameraSpread&) const = default;

    bool isExact() const { return focalShare <= 0.0 && principalPx <= 0.0; }

    /// Of the parameters of a camera in the order of CameraError; never quite zero.
    Eigen::Vector3d std() const { return Eigen::Vector3d(focalShare, principalPx, principalPx).cwiseMax(1e-9); }
};

/// By where the C-arm's values come from; `camera` is what follows from them.
CameraSpread spreadByOrigin(const CArm& cArm, const ProjectionCamera& camera);

/// Of a camera that was typed as a whole.
CameraSpread spreadOfTyped(const ProjectionCamera& camera);

/// The camera that an error of this one makes the true one.
ProjectionCamera corrected(const ProjectionCamera& camera, const CameraError& error);

/// The C-arm whose camera that is: of distance and spacing the less certain one takes the error of the focal length.
/// What is changed counts as derived, on this basis. `camera`: what follows from the C-arm as it is.
CArm corrected(CArm cArm, const ProjectionCamera& camera, const CameraError& error, const std::string& basis);

}   // namespace angiopose::core
