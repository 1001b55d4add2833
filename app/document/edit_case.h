#pragma once

#include "app/document/case_document.h"
#include "app/document/set_fields.h"

#include <memory>

namespace angiopose::app {

using core::RegistrationCase;

/// A hand edit of the pose: what the last run said no longer holds.
using MovePose = SetFields<&RegistrationCase::cameraFromPatient, &RegistrationCase::result>;

/// The same, and the other views move along.
using MoveAllPoses =
    SetFields<&RegistrationCase::cameraFromPatient, &RegistrationCase::result, &RegistrationCase::otherViews>;

/// What a run found, and the snapshot it leaves.
using ApplyRun =
    SetFields<&RegistrationCase::cameraFromPatient, &RegistrationCase::result, &RegistrationCase::snapshots>;

using ChangeSnapshots = SetFields<&RegistrationCase::snapshots>;

/// A blind trial: another start pose, and nothing in sight of what was found before.
using HideWhatIsKnown =
    SetFields<&RegistrationCase::cameraFromPatient, &RegistrationCase::hasInitialPose,
              &RegistrationCase::initialCameraFromPatient, &RegistrationCase::result, &RegistrationCase::snapshots>;

/// Another frame; where the gantry turned, the poses turn with it.
using ShowFrame = SetFields<&RegistrationCase::frame, &RegistrationCase::initialCameraFromPatient,
                            &RegistrationCase::cameraFromPatient, &RegistrationCase::result>;
using ChooseAuxiliary = SetFields<&RegistrationCase::auxiliaryBranchIds>;
using ExcludeBranches = SetFields<&RegistrationCase::excludedBranchIds, &RegistrationCase::result>;
using HideBranches = SetFields<&RegistrationCase::hiddenBranchIds>;
using RelabelTree = SetFields<&RegistrationCase::tree, &RegistrationCase::isTreeEdited>;
using EditTree =
    SetFields<&RegistrationCase::tree, &RegistrationCase::isTreeEdited, &RegistrationCase::auxiliaryBranchIds,
              &RegistrationCase::excludedBranchIds, &RegistrationCase::hiddenBranchIds,
              &RegistrationCase::cameraFromPatient, &RegistrationCase::result>;
using TraceTree =
    SetFields<&RegistrationCase::centerlineFile, &RegistrationCase::scanFile, &RegistrationCase::scanSeriesId,
              &RegistrationCase::vesselInput, &RegistrationCase::lumen, &RegistrationCase::tree,
              &RegistrationCase::isTreeEdited, &RegistrationCase::auxiliaryBranchIds,
              &RegistrationCase::excludedBranchIds, &RegistrationCase::hiddenBranchIds,
              &RegistrationCase::cameraFromPatient, &RegistrationCase::result>;
using ChangeOptions = SetFields<&RegistrationCase::options>;
using ChangeGeometry = SetFields<&RegistrationCase::cArm, &RegistrationCase::cameraOverride,
                                 &RegistrationCase::cameraFromPatient, &RegistrationCase::result>;
using ChangeViews = SetFields<&RegistrationCase::otherViews>;

/// What a run over all views found, in each of them.
using ApplyJointRun = SetFields<&RegistrationCase::cameraFromPatient, &RegistrationCase::result,
                                &RegistrationCase::snapshots, &RegistrationCase::otherViews>;

/// Another view in the place of the shown one, which takes its place among the others.
using ShowView = SetFields<&RegistrationCase::otherViews, &RegistrationCase::imageFile, &RegistrationCase::angiogram,
                           &RegistrationCase::storedRun, &RegistrationCase::headerPlan, &RegistrationCase::treatment,
                           &RegistrationCase::frame, &RegistrationCase::targetFile, &RegistrationCase::givenTarget,
                           &RegistrationCase::editedFrame, &RegistrationCase::acceptedCurveIds,
                           &RegistrationCase::traceOptions, &RegistrationCase::cArm, &RegistrationCase::cameraOverride,
                           &RegistrationCase::hasInitialPose, &RegistrationCase::initialCameraFromPatient,
                           &RegistrationCase::cameraFromPatient, &RegistrationCase::landmarks,
                           &RegistrationCase::result, &RegistrationCase::snapshots, &RegistrationCase::viewExtraKeys>;

using PickPivot = SetFields<&RegistrationCase::pickedPivotInPatient>;
using ChangeLandmarks = SetFields<&RegistrationCase::landmarks>;

/// A start pose found by hand or landmarks becomes the case's own.
using PlaceVessels = SetFields<&RegistrationCase::hasInitialPose, &RegistrationCase::initialCameraFromPatient,
                               &RegistrationCase::cameraFromPatient, &RegistrationCase::result>;

using ChangeTracing = SetFields<&RegistrationCase::traceOptions, &RegistrationCase::result>;

/// Another target: the result of the last run was found with the former one.
using ChangeTarget =
    SetFields<&RegistrationCase::targetFile, &RegistrationCase::givenTarget, &RegistrationCase::editedFrame,
              &RegistrationCase::acceptedCurveIds, &RegistrationCase::result>;
using ChangeTreatment = SetFields<&RegistrationCase::treatment, &RegistrationCase::angiogram,
                                  &RegistrationCase::storedRun, &RegistrationCase::result>;
using JoinInputs =
    SetFields<&RegistrationCase::title, &RegistrationCase::centerlineFile, &RegistrationCase::vesselInput,
              &RegistrationCase::volume, &RegistrationCase::scanFile, &RegistrationCase::scanSeriesId,
              &RegistrationCase::scanIdentity, &RegistrationCase::lumen, &RegistrationCase::tree,
              &RegistrationCase::isTreeEdited, &RegistrationCase::hiddenBranchIds,
              &RegistrationCase::auxiliaryBranchIds, &RegistrationCase::excludedBranchIds,
              &RegistrationCase::pickedPivotInPatient, &RegistrationCase::imageFile, &RegistrationCase::angiogram,
              &RegistrationCase::storedRun, &RegistrationCase::headerPlan, &RegistrationCase::treatment,
              &RegistrationCase::frame, &RegistrationCase::targetFile, &RegistrationCase::givenTarget,
              &RegistrationCase::editedFrame, &RegistrationCase::acceptedCurveIds, &RegistrationCase::cArm,
              &RegistrationCase::cameraOverride, &RegistrationCase::hasInitialPose,
              &RegistrationCase::cameraFromPatient, &RegistrationCase::landmarks, &RegistrationCase::result>;

/// The edit that makes the document's case like `wanted`, geometry only.
std::unique_ptr<QUndoCommand> changeGeometry(CaseDocument& document, const RegistrationCase& wanted,
                                             const ui::Words& name);

/// The edit that puts an edited tree into the case. Marks of branches that are gone go too; a pose at the start stays
/// there; what the last run said no longer holds.
std::unique_ptr<QUndoCommand> editTree(CaseDocument& document, core::VesselTree tree, const ui::Words& name);

/// The edit that puts a newly traced tree into the case, with how it was traced.
struct TracedTree {
    core::InputFile file;   ///< that it was traced from
    core::VesselInput input;
    std::shared_ptr<const core::VoxelMask> lumen;
    std::shared_ptr<const core::VesselTree> tree;
};
std::unique_ptr<QUndoCommand> takeTrace(CaseDocument& document, const TracedTree& traced, const ui::Words& name);

/// The edit that makes the document's case like `wanted`, as far as views go; see core::showingView.
std::unique_ptr<QUndoCommand> showView(CaseDocument& document, const RegistrationCase& wanted, const ui::Words& name);

/// The edit that takes over the inputs of `wanted` and all that hangs on them.
std::unique_ptr<QUndoCommand> joinInputs(CaseDocument& document, const RegistrationCase& wanted, const ui::Words& name);

}   // namespace angiopose::app