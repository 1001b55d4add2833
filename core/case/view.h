#pragma once

#include "core/case/input_file.h"
#include "core/case/separate_devices.h"
#include "core/case/tracked_run.h"
#include "core/geometry/camera_uncertainty.h"
#include "core/geometry/image_annotation.h"
#include "core/geometry/image_measurement.h"
#include "core/geometry/landmark.h"
#include "core/geometry/target_observation.h"
#include "core/imaging/angiogram.h"
#include "core/registration/pose_snapshot.h"
#include "core/registration/registration.h"
#include "core/tracing/angiogram/run/subtract_run.h"
#include "core/tracing/angiogram/trace_angiogram.h"
#include "core/vessel/centerline2d.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace angiopose::core {

/// A 2-D centerline used instead of a traced one: read from a file, or edited manually for one frame.
struct GivenTarget {
    InputFile file;   ///< path is empty if no target is given or the edits are not saved yet
    std::shared_ptr<const Centerline2d> centerline;   ///< contents of `file`, or the edited curves; otherwise null
    std::optional<int> editedFrame;   ///< frame in which the curves were edited; they are valid for this frame only
    std::vector<int> acceptedCurveIds;   ///< suspect curves among the edited ones that the user accepted
    /// Catheters and guidewires among the edited curves, stored separately from `centerline`; null if there are none.
    std::shared_ptr<const Centerline2d> devices{};
};

/// Geometry of the X-ray source, the detector and the patient relative to each other.
struct ViewGeometry {
    CArm cArm;   ///< header values, overridden by the values of the case
    std::optional<ProjectionCamera> cameraOverride;   ///< complete camera that replaces the C-arm values
};

/// One angiogram of the vessels with all its data. A view is small enough to copy for undo and for worker threads: the
/// images are shared and never change after loading.
struct View {
    InputFile caseFile;   ///< case file that contains the view unchanged; empty path if this case stores the view

    std::string name;   ///< name given by the user; if empty, the view is labeled by its angles
    bool isSamePatient = false;   ///< whether the user confirmed the patient identity despite contradictory headers
    InputFile imageFile;
    std::shared_ptr<const Angiogram> angiogram;   ///< the run as displayed and traced; null until loaded
    std::shared_ptr<const Angiogram> storedRun;   ///< the run as stored, if `treatment` changes it; otherwise null
    SubtractionPlan headerPlan;   ///< mask subtraction described in the header
    RunProcessing processing;   ///< how `angiogram` is derived from the stored run
    int frame = 0;
    GivenTarget target;
    TraceOptions traceOptions;

    ViewGeometry geometry;

    std::optional<RigidTransform> initialCameraFromPatient;   ///< if not set, the initial pose follows from the angles
    RigidTransform cameraFromPatient;   ///< current pose of the tree
    std::vector<Landmark> landmarks;   ///< landmark pairs from which the initial pose can be computed
    std::vector<ImageMeasurement> measurements;   ///< measurements drawn on the frames of the view
    std::optional<double> enteredMmPerPx;   ///< pixel spacing at the patient, entered by the user
    std::vector<TargetObservation> observations;   ///< image positions of target points, one per target point and frame
    std::vector<ImageAnnotation> annotations;   ///< arrows and text drawn on the frames of the view
    std::optional<RegistrationResult> result;   ///< result of the last registration; discarded when the pose changes
    TrackedRun followed;   ///< result of tracking the vessels through this view's cine run
    std::vector<PoseSnapshot> snapshots;   ///< poses saved by the user and by registrations, oldest first

    std::string extraKeys;   ///< JSON object with this view's keys in the file that this version does not recognize
};

/// Returns the registration result if it was found in the shown frame; otherwise null, because its quality measures are
/// valid for that frame only.
const RegistrationResult* resultOfShownFrame(const View& view);

/// Discards the registration result and the tracking result after one of their inputs changed.
void discardResults(View& view);

/// Returns the camera of a view: the override, which must match the image size, or the camera derived from the C-arm
/// and the image size.
Result<ProjectionCamera> cameraOf(const View& view);

/// Returns the uncertainty of the view's camera, derived from the origin of its values; zero if there is no camera.
CameraUncertainty cameraUncertaintyOf(const View& view);

/// Returns the C-arm at the time of the selected frame: the gantry may rotate during a run (ALGORITHMS §5.5).
CArm cArmOfFrame(const View& view);

/// Returns the alternative interpretation of the angles, relative to the table instead of the patient, if the header
/// gives a patient position other than head first supine. Returns nullopt for angles entered by the user, or if a
/// camera or an initial pose overrides the angles.
std::optional<TableAngles> tableAnglesOf(const View& view);

/// Returns messages about implausible values in the geometry of a view (see findContradictions); none if a camera
/// overrides that geometry.
Messages contradictionsOf(const View& view);

/// Returns the frames as stored in the file; null until loaded.
const std::shared_ptr<const Angiogram>& storedRunOf(const View& view);

/// Returns the given or edited centerline for the view's frame; null if there is none and the frame must be traced.
std::shared_ptr<const Centerline2d> givenTargetOf(const View& view);

/// Returns the catheters and guidewires that the user marked in the view's frame; null if there are none.
std::shared_ptr<const Centerline2d> devicesOf(const View& view);

/// Returns the vessels and the devices of a given target separately.
SeparatedCurves curvesOf(const GivenTarget& target);

/// Returns the tracing options for the view's frames. If the width of the widest vessel is not set, it is derived from
/// the view's geometry.
TraceOptions traceOptionsOf(const View& view);

/// Returns the target of a view: the given centerline, or the traced frame.
Result<Centerline2d> targetOf(const View& view);

/// Returns the target for a method: the marked devices for `wire`, if there are any; otherwise the view's target.
Result<Centerline2d> targetOf(const View& view, const std::string& method);

}   // namespace angiopose::core
