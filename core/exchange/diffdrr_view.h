#pragma once

#include "core/geometry/sight.h"

#include <string_view>

namespace angiopose::core {

/// What DiffDRR turns its C-arm by before the pose: not at all, or so that it looks from the front or from the back.
enum class DiffDrrOrientation { None, Ap, Pa };

/// The detector of DiffDRR. Its source lies in the origin and looks along z.
struct DiffDrrDetector {
    double sddMm = 0.0;   ///< source to detector
    int height = 0;
    int width = 0;
    double delxMm = 0.0;   ///< pixel spacing along the columns
    double delyMm = 0.0;   ///< along the rows
    double x0Mm = 0.0;   ///< how far the detector lies off the axis, as it is given to DiffDRR
    double y0Mm = 0.0;
    bool isXReversed = true;   ///< `reverse_x_axis`
    DiffDrrOrientation orientation = DiffDrrOrientation::Ap;
};

/// What DiffDRR and xvr say of one radiograph: `worldFromCamera = pose * orientation`, world RAS mm with the centre of
/// the volume in its origin.
struct DiffDrrView {
    DiffDrrDetector detector;
    RigidTransform pose;
    Eigen::Vector3d volumeCenterInPatient = Eigen::Vector3d::Zero();   ///< LPS mm, of the grid's corners
};

/// Our camera and pose of it.
Sight sightFromDiffDrr(const DiffDrrView& view);

/// Ours as DiffDRR has it, with reversed x: from the back where the image is as seen from the detector (fx < 0), from
/// the front where it is mirrored. Only the ratio of distance and spacing matters to the projection; fy > 0.
DiffDrrView diffDrrView(const Sight& sight, double sddMm, const Eigen::Vector3d& volumeCenterInPatient);

/// Its pose from Euler angles, rad, about the named axes ("ZXY": R = Rz Rx Ry), and a translation that turns with them.
RigidTransform diffDrrPose(std::string_view axes, const Eigen::Vector3d& angles, const Eigen::Vector3d& translationMm);

/// The other way for "ZXY": angles, then translation.
Vector6d diffDrrParameters(const RigidTransform& pose);

}   // namespace angiopose::core
