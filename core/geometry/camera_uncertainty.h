#pragma once

#include "core/geometry/c_arm.h"

namespace angiopose::core {

/// Error of a camera: logarithm of the focal length (true over assumed), then cx and cy in px (true minus assumed).
using CameraError = Eigen::Vector3d;

/// Uncertainty of a camera, 1 σ (ALGORITHMS §5.8). If all values are zero, the camera is assumed to be exact.
struct CameraUncertainty {
    double relativeFocalStd =
        0.0;   ///< relative, common to fx and fy; due to source-to-detector distance and pixel spacing
    double principalPx = 0.0;   ///< standard deviation of cx and cy, px
    CameraError appliedError =
        CameraError::Zero();   ///< correction already applied to the camera; the distribution is centered on it

    bool operator==(const CameraUncertainty&) const = default;

    bool isExact() const { return relativeFocalStd <= 0.0 && principalPx <= 0.0; }

    /// Returns the standard deviations of the camera parameters in the order of CameraError; never exactly zero.
    Eigen::Vector3d std() const { return Eigen::Vector3d(relativeFocalStd, principalPx, principalPx).cwiseMax(1e-9); }
};

/// Returns the camera uncertainty given by the origins of the C-arm's values; `camera` is derived from these values.
CameraUncertainty uncertaintyByOrigin(const CArm& cArm, const ProjectionCamera& camera);

/// Returns the uncertainty of a camera whose parameters the user entered directly.
CameraUncertainty enteredCameraUncertainty(const ProjectionCamera& camera);

/// Returns the camera corrected by `error`.
ProjectionCamera applyCameraError(const ProjectionCamera& camera, const CameraError& error);

/// Returns the C-arm of the corrected camera: of distance and spacing, the less certain one takes the focal-length
/// error. Changed values get the origin Derived and this basis. `camera` is the camera of the uncorrected C-arm.
CArm applyCameraError(CArm cArm, const ProjectionCamera& camera, const CameraError& error, const std::string& basis);

}   // namespace angiopose::core
