#pragma once

#include "core/geometry/projection_camera.h"
#include "core/geometry/rigid_transform.h"
#include "core/support/result.h"

#include <optional>
#include <string>

namespace angiopose::core {

/// Where a geometry value comes from; shown beside it wherever it is shown.
enum class Origin { Missing, Header, Derived, User, Assumed };

/// A value that knows where it comes from. `basis` says it in words ("(0018,1110)", "intensifier 204.8 mm / 512 px").
template <class T>
struct Sourced {
    std::optional<T> value;
    Origin origin = Origin::Missing;
    std::string basis;
};

/// C-arm geometry as DICOM describes it (PS3.3 C.8.7.5; ALGORITHMS §5). Lengths mm, angles degrees.
struct CArm {
    Sourced<double> sourceToDetectorMm;   ///< SID
    Sourced<double> sourceToIsocenterMm;   ///< SOD: the gantry turns about what lies there
    Sourced<double> sourceToObjectMm;   ///< plane of the object that the device assumes, see vesselDepthOf
    Sourced<double> columnSpacingMm;   ///< detector pixel pitch along u
    Sourced<double> rowSpacingMm;   ///< detector pixel pitch along v
    Sourced<double> primaryAngleDeg;   ///< LAO +, RAO −
    Sourced<double> secondaryAngleDeg;   ///< CRA +, CAU −
    Sourced<double> rollDeg;   ///< image turned clockwise on screen; missing: 0
    Sourced<Eigen::Vector2d> principalPointPx;   ///< (cx, cy); missing: image centre
    Sourced<bool> mirrored;   ///< true: shown as seen from the source, fx > 0
    Sourced<Eigen::Vector3d> isocenterInPatientMm;   ///< in the vessels' coordinates; missing: their centroid
};

/// Takes the object plane for the isocenter where nothing else is known of that; as assumed.
void assumeIsocenter(CArm& cArm);

/// Where the vessels lie along the beam before anything is known of them: in the object plane, else at the isocenter.
const Sourced<double>& vesselDepthOf(const CArm& cArm);

/// Directions of an image in patient LPS, unit vectors.
struct ImageAxes {
    Eigen::Vector3d right;
    Eigen::Vector3d down;
};

/// How the image of a C-arm lies, its roll and mirror included; angles that are missing count as 0.
ImageAxes imageAxesOf(CArm cArm);

/// The C-arm when it has turned by (primary, secondary) degrees since its angles were noted.
CArm turnedBy(CArm cArm, const Eigen::Vector2d& incrementsDeg);

/// Pin-hole camera of the C-arm: fx = −SID/Δu (positive when mirrored), fy = SID/Δv, ALGORITHMS §5.2.
/// Fails naming the value that is missing or impossible and how to supply it.
Result<ProjectionCamera> cameraFromCArm(const CArm& cArm, int width, int height);

/// Pose of the C-arm about an isocentre given in patient LPS mm (ALGORITHMS §5.3). det R = +1 always.
/// Fails when SOD or an angle is missing.
Result<RigidTransform> cameraFromPatient(const CArm& cArm, const Eigen::Vector3d& isocenterInPatient);

/// Unit vector from isocentre to detector in patient LPS for the given angles: LAO 90° points to the patient's left.
Eigen::Vector3d detectorDirection(double primaryAngleDeg, double secondaryAngleDeg);

}   // namespace angiopose::core