#pragma once

#include "core/geometry/sight.h"

#include <string_view>

namespace angiopose::core {

/// Rotation that DiffDRR applies to its C-arm before the pose: none, or to view from anterior (AP) or from posterior
/// (PA).
enum class DiffDrrOrientation { None, Ap, Pa };

/// Detector of DiffDRR. The source is at the origin and looks along z.
struct DiffDrrDetector {
    double sddMm = 0.0;   ///< source-to-detector distance
    int height = 0;
    int width = 0;
    double delxMm = 0.0;   ///< pixel spacing along the columns
    double delyMm = 0.0;   ///< pixel spacing along the rows
    double x0Mm = 0.0;   ///< detector offset from the axis, as passed to DiffDRR
    double y0Mm = 0.0;
    bool isXReversed = true;   ///< `reverse_x_axis`
    DiffDrrOrientation orientation = DiffDrrOrientation::Ap;
};

/// DiffDRR or xvr parameters of one image: `worldFromCamera = pose * orientation`, world RAS mm with the center of the
/// volume at its origin.
struct DiffDrrView {
    DiffDrrDetector detector;
    RigidTransform pose;
    Eigen::Vector3d volumeCenterInPatient = Eigen::Vector3d::Zero();   ///< LPS mm, center of the grid's corners
};

/// Converts it to our camera and pose.
Sight sightFromDiffDrr(const DiffDrrView& view);

/// Converts our camera and pose to DiffDRR, with reversed x: PA if the image is as seen from the detector (fx < 0), AP
/// if it is mirrored. The projection depends only on the ratio of distance and spacing; fy > 0.
DiffDrrView diffDrrView(const Sight& sight, double sddMm, const Eigen::Vector3d& volumeCenterInPatient);

/// Returns the DiffDRR pose for Euler angles, rad, about the named axes ("ZXY": R = Rz Rx Ry), and a translation that
/// rotates with them.
RigidTransform diffDrrPose(std::string_view axes, const Eigen::Vector3d& angles, const Eigen::Vector3d& translationMm);

/// Inverse of diffDrrPose for "ZXY": angles, then translation.
Vector6d diffDrrParameters(const RigidTransform& pose);

}   // namespace angiopose::core
