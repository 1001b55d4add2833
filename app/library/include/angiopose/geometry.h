#pragma once

#include "angiopose/export.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>

// Coordinate frames. Patient: LPS, mm. Camera: mm, origin in the X-ray source, Z > 0 toward the detector. Image: px, u
// right (column), v down (row); (0, 0) is the center of the first pixel. The value types use no Eigen alignment, so
// that their memory layout does not depend on the processor options with which a program is compiled.

namespace angiopose {

/// Rigid transform as a 4×4 matrix: `cameraFromPatient` maps patient points (x, y, z, 1) in mm to camera points in mm.
using Pose = Eigen::Matrix<double, 4, 4, Eigen::RowMajor | Eigen::DontAlign>;
using Matrix6d = Eigen::Matrix<double, 6, 6, Eigen::RowMajor | Eigen::DontAlign>;
using Vector6d = Eigen::Matrix<double, 6, 1, Eigen::DontAlign>;

/// Pinhole model of X-ray source and detector: u = fx X/Z + cx, v = fy Y/Z + cy. The sign of fx matters: with the wrong
/// sign the image is mirrored, and a tree with few branches may still fit it.
struct ProjectionCamera {
    double fx = 0.0;   ///< focal length, px; negative for a standard image, viewed from the detector side
    double fy = 0.0;   ///< focal length, px
    double cx = 0.0;   ///< principal point, px
    double cy = 0.0;   ///< principal point, px
    int width = 0;   ///< columns of the image
    int height = 0;   ///< rows of the image
};

/// C-arm geometry as in DICOM; lengths in mm, angles in degrees. Values that are not set are unknown.
struct CArm {
    std::optional<double> sourceToDetectorMm;
    std::optional<double> sourceToPatientMm;   ///< distance from source to isocenter
    std::optional<double> columnSpacingMm;   ///< pixel spacing on the detector along u
    std::optional<double> rowSpacingMm;   ///< pixel spacing on the detector along v
    std::optional<double> primaryAngleDeg;   ///< LAO +, RAO −
    std::optional<double> secondaryAngleDeg;   ///< CRA +, CAU −
    std::optional<double> rollDeg;   ///< clockwise rotation of the displayed image; 0 if not set
    std::optional<double> principalPointUPx;   ///< image center if not set
    std::optional<double> principalPointVPx;   ///< image center if not set
    bool mirrored = false;   ///< true if the image is viewed from the source side
    std::optional<Eigen::Vector3d> isocenterInPatientMm;   ///< not set if unknown in the coordinates of the vessels
};

/// Returns the camera of a C-arm for images of this size; requires sourceToDetectorMm and the pixel spacings.
ANGIOPOSE_EXPORT ProjectionCamera cameraFromCArm(const CArm& cArm, int width, int height);

/// Returns the pose of a C-arm that rotates about the isocenter (LPS, mm); requires sourceToPatientMm and both angles.
ANGIOPOSE_EXPORT Pose cameraFromPatient(const CArm& cArm, const Eigen::Vector3d& isocenterInPatient);

/// Projects a patient point (mm) to the image (px); nullopt if the point is at or behind the source.
ANGIOPOSE_EXPORT std::optional<Eigen::Vector2d> project(const ProjectionCamera& camera, const Pose& cameraFromPatient,
                                                        const Eigen::Vector3d& pointInPatient);

}   // namespace angiopose
