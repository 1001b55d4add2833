#pragma once

#include "core/geometry/posed_camera.h"

#include <string_view>

namespace angiopose::core {

/// Rotation that DiffDRR applies to its C-arm before the pose: none, or that of an anterior (AP) or posterior (PA)
/// view.
enum class DiffDrrOrientation { None, Ap, Pa };

/// DiffDRR's detector. The source is at the origin and the beam points along z.
struct DiffDrrDetector {
    double sddMm = 0.0;   ///< source-to-detector distance
    int height = 0;
    int width = 0;
    double delxMm = 0.0;   ///< pixel spacing along the columns
    double delyMm = 0.0;   ///< pixel spacing along the rows
    double x0Mm = 0.0;   ///< offset of the detector from the beam axis, as passed to DiffDRR
    double y0Mm = 0.0;
    bool isXReversed = true;   ///< DiffDRR's `reverse_x_axis`
    DiffDrrOrientation orientation = DiffDrrOrientation::Ap;
};

/// DiffDRR or xvr parameters of one image: `worldFromCamera = pose * orientation`. The world frame is RAS, mm, with its
/// origin at the center of the volume.
struct DiffDrrView {
    DiffDrrDetector detector;
    RigidTransform pose;
    Eigen::Vector3d volumeCenterInPatient = Eigen::Vector3d::Zero();   ///< LPS mm, center of the grid's corners
};

/// Converts a DiffDRR view to our camera and pose.
PosedCamera posedCameraFromDiffDrr(const DiffDrrView& view);

/// Converts our camera and pose to DiffDRR, with reversed x: PA if the image is as seen from the detector (fx < 0), AP
/// if it is mirrored. The projection depends only on the ratio of distance to spacing, and fy must be positive.
DiffDrrView diffDrrView(const PosedCamera& posedCamera, double sddMm, const Eigen::Vector3d& volumeCenterInPatient);

/// Returns the DiffDRR pose for Euler angles (rad) about the named axes ("ZXY": R = Rz Rx Ry) and a translation that is
/// rotated with them.
RigidTransform diffDrrPose(std::string_view axes, const Eigen::Vector3d& angles, const Eigen::Vector3d& translationMm);

/// Inverts diffDrrPose for "ZXY": returns the angles, followed by the translation.
Vector6d diffDrrParameters(const RigidTransform& pose);

}   // namespace angiopose::core
