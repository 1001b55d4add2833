#pragma once

#include "core/geometry/c_arm.h"
#include "core/imaging/angiogram.h"
#include "core/imaging/volume.h"
#include "core/registration/pose_snapshot.h"
#include "core/registration/registration.h"
#include "core/tracing/trace_angiogram.h"
#include "core/vessel/centerline2d.h"
#include "core/vessel/vessel_input.h"
#include "core/vessel/vessel_tree.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace core {

/// A file the case refers to.
struct InputFile {
    std::string path;   ///< absolute; empty when there is none
    std::string sha256;   ///< lower-case hex of the content when it was read; empty when not yet known

    bool operator==(const InputFile&) const = default;
};

/// Everything one session edits; saved and loaded as a whole, and small enough to copy for undo and for workers.
/// The large inputs are shared and never change once loaded.
struct RegistrationCase {
    std::string title;

    InputFile centerlineFile;   ///< centrelines, or what they are traced from; a folder for a DICOM series
    VesselInput vesselInput;   ///< what that file is, and how it is traced
    std::shared_ptr<const Volume> volume;   ///< the scan the tree was traced from, or null
    StudyIdentity scanIdentity;   ///< of the patient in the scan, where it is DICOM
    std::shared_ptr<const VesselTree> tree;   ///< null until loaded
    std::vector<int> auxiliaryBranchIds;
    std::vector<int> excludedBranchIds;

    InputFile imageFile;
    std::shared_ptr<const Angiogram> angiogram;   ///< null until loaded
    int frame = 0;
    InputFile targetFile;   ///< a given 2-D centreline that replaces tracing
    std::shared_ptr<const Centerline2d> givenTarget;   ///< content of targetFile, or null
    TraceOptions traceOptions;

    CArm cArm;   ///< header values, overridden by the case's own
    std::optional<ProjectionCamera> cameraOverride;   ///< `geometry.camera` of the case file

    RigidTransform initialCameraFromPatient;
    bool hasInitialPose = false;   ///< false: the start pose follows from the angles
    RigidTransform cameraFromPatient;   ///< where the tree is now

    RegistrationOptions options;
    std::string extraKeys;   ///< JSON object with the keys of the case file that this version does not know
    std::optional<RegistrationResult> result;   ///< of the last run, while the pose is still its pose
    std::vector<PoseSnapshot> snapshots;   ///< poses kept by the user and left by runs, oldest first
};

/// The camera of the case: the override, or what follows from the C-arm and the image size.
Result<ProjectionCamera> cameraOf(const RegistrationCase& registrationCase);

/// The start pose of the case: given, or from the angles with the tree's centroid in the isocentre.
Result<RigidTransform> startPoseOf(const RegistrationCase& registrationCase);

/// The target of the case: the given centreline, or the traced frame.
Result<Centerline2d> targetOf(const RegistrationCase& registrationCase);

/// The snapshot a worker needs; fails naming what the case still lacks. The registration starts from the current pose.
Result<RegistrationInput> registrationInputOf(const RegistrationCase& registrationCase, Centerline2d target);

}   // namespace core
