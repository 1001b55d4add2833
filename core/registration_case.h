#pragma once

#include "core/geometry/c_arm.h"
#include "core/geometry/landmark.h"
#include "core/imaging/angiogram.h"
#include "core/imaging/volume.h"
#include "core/registration/pose_snapshot.h"
#include "core/registration/registration.h"
#include "core/tracing/subtract_run.h"
#include "core/tracing/trace_angiogram.h"
#include "core/vessel/centerline2d.h"
#include "core/vessel/vessel_input.h"
#include "core/vessel/vessel_tree.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace angiopose::core {

/// A file the case refers to.
struct InputFile {
    std::string path;   ///< absolute; empty when there is none
    std::string sha256;   ///< lower-case hex of the content when it was read; empty when not yet known

    bool operator==(const InputFile&) const = default;
};

struct RegistrationCase;

/// Another angiogram of the same vessels, registered together with the case's own.
struct OtherView {
    InputFile file;   ///< the case file it stands in; no path: it stands in this case itself
    /// Its image, geometry and pose, see viewOf; null where only the file is known. Without an angiogram where that
    /// could not be read.
    std::shared_ptr<const RegistrationCase> view;

    bool operator==(const OtherView&) const = default;
};

/// Everything one session edits; saved and loaded as a whole, and small enough to copy for undo and for workers.
/// The large inputs are shared and never change once loaded.
struct RegistrationCase {
    std::string title;

    InputFile centerlineFile;   ///< centrelines, or what they are traced from; a folder for a DICOM series
    VesselInput vesselInput;   ///< what that file is, and how it is traced
    std::shared_ptr<const Volume> volume;   ///< the scan the tree was traced from or lies in, or null
    InputFile scanFile;   ///< of `volume`, where the tree does not come from it
    std::string scanSeriesId;   ///< of `scanFile`, where that is a DICOM folder
    StudyIdentity scanIdentity;   ///< of the patient in the scan, where it is DICOM
    std::shared_ptr<const VoxelMask> lumen;   ///< the voxels the tree was traced from, or null
    std::shared_ptr<const VesselTree> tree;   ///< null until loaded
    bool isTreeEdited = false;   ///< by hand: no longer what the file gives, so that the case keeps the tree itself
    std::vector<int> auxiliaryBranchIds;
    std::vector<int> excludedBranchIds;
    std::vector<int> hiddenBranchIds;   ///< count, but are not drawn
    std::optional<Eigen::Vector3d> pickedPivotInPatient;   ///< see pivotInPatient

    InputFile imageFile;
    std::shared_ptr<const Angiogram> angiogram;   ///< as it is shown and traced; null until loaded
    std::shared_ptr<const Angiogram> storedRun;   ///< as the file has it, while `treatment` changes it; else null
    SubtractionPlan headerPlan;   ///< what the file says about its subtraction
    RunTreatment treatment;   ///< how `angiogram` comes from what is stored
    int frame = 0;
    InputFile targetFile;   ///< a given 2-D centreline that replaces tracing; no path while edits are not saved
    std::shared_ptr<const Centerline2d> givenTarget;   ///< content of targetFile, or edited curves, or null
    std::optional<int> editedFrame;   ///< the given target was edited here, and holds for this frame alone
    std::vector<int> acceptedCurveIds;   ///< of the edited target: no suspects, says the user
    TraceOptions traceOptions;

    CArm cArm;   ///< header values, overridden by the case's own
    std::optional<ProjectionCamera> cameraOverride;   ///< `geometry.camera` of the case file

    RigidTransform initialCameraFromPatient;
    bool hasInitialPose = false;   ///< false: the start pose follows from the angles
    RigidTransform cameraFromPatient;   ///< where the tree is now
    std::vector<Landmark> landmarks;   ///< pairs the start pose can be found from
    std::vector<OtherView> otherViews;

    RegistrationOptions options;
    std::string extraKeys;   ///< JSON object with the keys of the case file that this version does not know
    std::string viewExtraKeys;   ///< likewise of what belongs to this view: image, geometry, poses
    std::optional<RegistrationResult> result;   ///< of the last run, while the pose is still its pose
    std::vector<PoseSnapshot> snapshots;   ///< poses kept by the user and left by runs, oldest first
};

/// What the vessels turn about by hand, and whose shifts are shown and locked: picked, or the tree's centroid; nothing
/// without a tree.
std::optional<Eigen::Vector3d> pivotInPatient(const RegistrationCase& registrationCase);

/// The camera of the case: the override, or what follows from the C-arm and the image size.
Result<ProjectionCamera> cameraOf(const RegistrationCase& registrationCase);

/// The C-arm when the chosen frame was taken: the gantry may turn during a run (ALGORITHMS §5.5).
CArm cArmOfFrame(const RegistrationCase& registrationCase);

/// What in the geometry of the case makes no sense, see findContradictions; nothing while a camera overrides it.
Messages contradictionsOf(const RegistrationCase& registrationCase);

/// The start pose of the case: given, or from the angles of the frame with the isocentre where the case has it, else in
/// the tree's centroid.
Result<RigidTransform> startPoseOf(const RegistrationCase& registrationCase);

/// The case at another frame. Where the gantry turned in between, the poses turn with it about the isocentre.
RegistrationCase withFrame(RegistrationCase registrationCase, int frame);

/// The frames as the file has them; null until loaded.
const std::shared_ptr<const Angiogram>& storedRunOf(const RegistrationCase& registrationCase);

/// The given or edited centreline, where there is one for the case's frame; else null, and the frame is traced.
std::shared_ptr<const Centerline2d> givenTargetOf(const RegistrationCase& registrationCase);

/// The target of the case: the given centreline, or the traced frame.
Result<Centerline2d> targetOf(const RegistrationCase& registrationCase);

/// The snapshot a worker needs; fails naming what the case still lacks. The registration starts from the current pose.
Result<RegistrationInput> registrationInputOf(const RegistrationCase& registrationCase, Centerline2d target);

}   // namespace angiopose::core