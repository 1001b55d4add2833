#pragma once

#include "core/case/devices_apart.h"
#include "core/case/followed_run.h"
#include "core/case/input_file.h"
#include "core/geometry/camera_spread.h"
#include "core/geometry/image_annotation.h"
#include "core/geometry/image_measurement.h"
#include "core/geometry/landmark.h"
#include "core/geometry/sighting.h"
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

/// A 2-D centreline that replaces tracing: from a file, or curves edited by hand for one frame.
struct GivenTarget {
    InputFile file;   ///< no path: nothing is given, or the edits are not saved yet
    std::shared_ptr<const Centerline2d> centerline;   ///< content of `file`, or the edited curves, or null
    std::optional<int> editedFrame;   ///< edited here, and holds for this frame alone
    std::vector<int> acceptedCurveIds;   ///< of the edited curves: no suspects, says the user
    /// Catheters and wires among the edited curves, kept apart: no part of `centerline`. Null: none.
    std::shared_ptr<const Centerline2d> devices{};
};

/// Where source and detector stand to each other and to the patient.
struct ViewGeometry {
    CArm cArm;   ///< header values, overridden by the case's own
    std::optional<ProjectionCamera> cameraOverride;   ///< given as a whole: what the C-arm says does not count
};

/// One angiogram of the vessels, with all that is known about it. Small enough to copy for undo and for workers: the
/// images are shared and never change once loaded.
struct View {
    InputFile caseFile;   ///< the case file the view stands in, unchanged; no path: it stands in this case itself

    std::string name;   ///< what the user calls it; empty: its angles say which it is
    bool isSamePatient = false;   ///< somebody made sure of that, whatever the headers say
    InputFile imageFile;
    std::shared_ptr<const Angiogram> angiogram;   ///< as it is shown and traced; null where it is not loaded
    std::shared_ptr<const Angiogram> storedRun;   ///< as the file has it, while `treatment` changes it; else null
    SubtractionPlan headerPlan;   ///< what the file says about its subtraction
    RunTreatment treatment;   ///< how `angiogram` comes from what is stored
    int frame = 0;
    GivenTarget target;
    TraceOptions traceOptions;

    ViewGeometry geometry;

    std::optional<RigidTransform> initialCameraFromPatient;   ///< none: the start pose follows from the angles
    RigidTransform cameraFromPatient;   ///< where the tree is now
    std::vector<Landmark> landmarks;   ///< pairs the start pose can be found from
    std::vector<ImageMeasurement> measurements;   ///< drawn on its frames
    std::optional<double> typedMmPerPx;   ///< what a pixel measures in the patient, as somebody says
    std::vector<Sighting> sightings;   ///< of check points of the vessels, one for each of them and frame
    std::vector<ImageAnnotation> annotations;   ///< arrows and words on its frames
    std::optional<RegistrationResult> result;   ///< of the last run, while the pose is still its pose
    FollowedRun followed;   ///< what following found in its run, from the frame and pose of then
    std::vector<PoseSnapshot> snapshots;   ///< poses kept by the user and left by runs, oldest first

    std::string extraKeys;   ///< JSON object with the keys of the file about this view that this version does not know
};

/// The result, where it was found in the frame that is shown: what it says of the fit holds for that one alone. Else
/// null.
const RegistrationResult* resultOfShownFrame(const View& view);

/// Something that they rest on is another: neither the run's result nor what following found holds any longer.
void forgetFindings(View& view);

/// The camera of a view: the override, which must be of the image size, or what follows from the C-arm and that size.
Result<ProjectionCamera> cameraOf(const View& view);

/// How far that camera may be off, by where its values come from; zero where there is none.
CameraSpread cameraSpreadOf(const View& view);

/// The C-arm when the chosen frame was taken: the gantry may turn during a run (ALGORITHMS §5.5).
CArm cArmOfFrame(const View& view);

/// How else its angles may be meant: by a device that counts them from the table, where the header says that the
/// patient does not lie head first and supine. Nothing of angles that somebody typed, or while a camera or a start pose
/// overrides them.
std::optional<TableReading> tableReadingOf(const View& view);

/// What in the geometry of a view makes no sense, see findContradictions; nothing while a camera overrides it.
Messages contradictionsOf(const View& view);

/// The frames as the file has them; null until loaded.
const std::shared_ptr<const Angiogram>& storedRunOf(const View& view);

/// The given or edited centreline, where there is one for the view's frame; else null, and the frame is traced.
std::shared_ptr<const Centerline2d> givenTargetOf(const View& view);

/// Catheters and wires of the view's frame that the user keeps apart; null where there are none.
std::shared_ptr<const Centerline2d> devicesOf(const View& view);

/// Of a given target: which curves are vessels, which are devices.
CurvesApart curvesOf(const GivenTarget& target);

/// How its frames are traced, with the widest vessel by the view's geometry where the options leave it open.
TraceOptions traceOptionsOf(const View& view);

/// The target of a view: the given centreline, or the traced frame.
Result<Centerline2d> targetOf(const View& view);

/// What a method registers to: `wire` follows the devices where some are kept apart; else the view's target.
Result<Centerline2d> targetOf(const View& view, const std::string& method);

}   // namespace angiopose::core
