#pragma once

#include "angiopose/export.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>

// Frames. Patient: LPS, mm. Camera: mm, origin in the X-ray source, Z > 0 towards the detector. Image: px, u right
// (column), v down (row), (0, 0) is the centre of the first pixel. Types that hold values do not ask Eigen for
// alignment, so that programs compiled for another processor than the library agree with it about their layout.

namespace angiopose {

/// Rigid motion as a 4×4 matrix: `cameraFromPatient` takes patient points (x, y, z, 1) in mm to camera points in mm.
using Pose = Eigen::Matrix<double, 4, 4, Eigen::RowMajor | Eigen::DontAlign>;
using Matrix6d = Eigen::Matrix<double, 6, 6, Eigen::RowMajor | Eigen::DontAlign>;
using Vector6d = Eigen::Matrix<double, 6, 1, Eigen::DontAlign>;

/// Pin-hole model of X-ray source and detector: u = fx X/Z + cx, v = fy Y/Z + cy. Mind the sign of fx: with the wrong
/// one the image is mirrored, and a tree of few branches may still fit it.
struct ProjectionCamera {
    double fx = 0.0;   ///< px; below 0 in a standard image, which is seen from the detector
    double fy = 0.0;   ///< px
    double cx = 0.0;   ///< px
    double cy = 0.0;   ///< px
    int width = 0;   ///< columns of the image
    int height = 0;   ///< rows of the image
};

/// C-arm as DICOM describes it; lengths mm, angles degrees. What is not set is not known.
struct CArm {
    std::optional<double> sourceToDetectorMm;
    std::optional<double> sourceToPatientMm;   ///< source to isocentre
    std::optional<double> columnSpacingMm;   ///< pixel pitch on the detector along u
    std::optional<double> rowSpacingMm;   ///< … along v
    std::optional<double> primaryAngleDeg;   ///< LAO +, RAO −
    std::optional<double> secondaryAngleDeg;   ///< CRA +, CAU −
    std::optional<double> rollDeg;   ///< image turned clockwise on screen; not set: 0
    std::optional<double> principalPointUPx;   ///< not set: image centre
    std::optional<double> principalPointVPx;   ///< not set: image centre
    bool mirrored = false;   ///< true: shown as seen from the source
    std::optional<Eigen::Vector3d> isocenterInPatientMm;   ///< not set: not known in the vessels' coordinates
};

/// The camera of a C-arm for images of this size; needs sourceToDetectorMm and the spacings.
ANGIOPOSE_EXPORT ProjectionCamera cameraFromCArm(const CArm& cArm, int width, int height);

/// The pose of a C-arm that turns about `isocenterInPatient` (LPS, mm); needs sourceToPatientMm and both angles.
ANGIOPOSE_EXPORT Pose cameraFromPatient(const CArm& cArm, const Eigen::Vector3d& isocenterInPatient);

/// The image point (px) of a patient point (mm); nothing when it lies at or behind the source.
ANGIOPOSE_EXPORT std::optional<Eigen::Vector2d> project(const ProjectionCamera& camera, const Pose& cameraFromPatient,
                                                        const Eigen::Vector3d& pointInPatient);

}   // namespace angiopose
