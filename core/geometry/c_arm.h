#pragma once

#include "core/geometry/projection_camera.h"
#include "core/geometry/rigid_transform.h"
#include "core/support/result.h"

#include <optional>
#include <string>

namespace angiopose::core {

/// Origin of a geometry value, displayed next to that value.
enum class Origin { Missing, Header, Derived, User, Assumed };

/// A value with its origin. `basis` describes the origin as text ("(0018,1110)", "intensifier 204.8 mm / 512 px").
template <class T>
struct SourcedValue {
    std::optional<T> value;
    Origin origin = Origin::Missing;
    std::string basis;
};

/// C-arm geometry as described by DICOM (PS3.3 C.8.7.5; ALGORITHMS §5). Lengths are in mm, angles in degrees.
struct CArm {
    SourcedValue<double> sourceToDetectorMm;   ///< source-to-detector distance (SID)
    SourcedValue<double> sourceToIsocenterMm;   ///< SOD: distance to the rotation center of the gantry
    SourcedValue<double> sourceToObjectMm;   ///< distance to the object plane assumed by the device, see vesselDepthOf
    SourcedValue<double> columnSpacingMm;   ///< detector pixel pitch along u
    SourcedValue<double> rowSpacingMm;   ///< detector pixel pitch along v
    SourcedValue<double> primaryAngleDeg;   ///< LAO +, RAO −
    SourcedValue<double> secondaryAngleDeg;   ///< CRA +, CAU −
    SourcedValue<double> rollDeg;   ///< clockwise rotation of the image on screen; 0 if missing
    SourcedValue<Eigen::Vector2d> principalPointPx;   ///< (cx, cy); the image center if missing
    SourcedValue<bool> mirrored;   ///< whether the image is shown as seen from the source (fx > 0)
    SourcedValue<Eigen::Vector3d>
        isocenterInPatientMm;   ///< in the vessels' coordinates; the vessels' centroid if missing
};

/// If the isocenter distance is unknown, sets it to the distance of the object plane, with origin Assumed.
void assumeIsocenter(CArm& cArm);

/// Returns the depth of the vessels along the beam before registration: the object plane, or else the isocenter.
const SourcedValue<double>& vesselDepthOf(const CArm& cArm);

/// Directions of the image axes in patient LPS, as unit vectors.
struct ImageAxes {
    Eigen::Vector3d right;
    Eigen::Vector3d down;
};

/// Returns the orientation of a C-arm image, including roll and mirroring; missing angles count as 0.
ImageAxes imageAxesOf(CArm cArm);

/// Returns the C-arm rotated by (primary, secondary) degrees from its stored angles.
CArm rotateCArm(CArm cArm, const Eigen::Vector2d& incrementsDeg);

/// Returns the pinhole camera of the C-arm: fx = −SID/Δu (positive if mirrored), fy = SID/Δv (ALGORITHMS §5.2). The
/// error names the missing or impossible value and states how to supply it.
Result<ProjectionCamera> cameraFromCArm(const CArm& cArm, int width, int height);

/// Returns the pose of the C-arm about an isocenter given in patient LPS, mm (ALGORITHMS §5.3). det R is always +1.
/// Fails if the SOD or an angle is missing.
Result<RigidTransform> cameraFromPatient(const CArm& cArm, const Eigen::Vector3d& isocenterInPatient);

/// Returns the unit vector from the isocenter to the detector in patient LPS for the given angles: LAO 90° points to
/// the patient's left.
Eigen::Vector3d detectorDirection(double primaryAngleDeg, double secondaryAngleDeg);

}   // namespace angiopose::core
