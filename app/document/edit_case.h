#pragma once

#include "app/document/case_document.h"
#include "app/document/set_fields.h"

#include <QString>

#include <memory>

namespace app {

using core::RegistrationCase;

/// A hand edit of the pose: what the last run said no longer holds.
using MovePose = SetFields<&RegistrationCase::cameraFromPatient, &RegistrationCase::result>;

/// What a run found, and the snapshot it leaves.
using ApplyRun =
    SetFields<&RegistrationCase::cameraFromPatient, &RegistrationCase::result, &RegistrationCase::snapshots>;

using ChangeSnapshots = SetFields<&RegistrationCase::snapshots>;

/// A blind trial: another start pose, and nothing in sight of what was found before.
using HideWhatIsKnown =
    SetFields<&RegistrationCase::cameraFromPatient, &RegistrationCase::hasInitialPose,
              &RegistrationCase::initialCameraFromPatient, &RegistrationCase::result, &RegistrationCase::snapshots>;

using ShowFrame = SetFields<&RegistrationCase::frame>;
using ChooseAuxiliary = SetFields<&RegistrationCase::auxiliaryBranchIds>;
using ExcludeBranches = SetFields<&RegistrationCase::excludedBranchIds, &RegistrationCase::result>;
using ChangeOptions = SetFields<&RegistrationCase::options>;
using ChangeGeometry = SetFields<&RegistrationCase::cArm, &RegistrationCase::cameraOverride,
                                 &RegistrationCase::cameraFromPatient, &RegistrationCase::result>;
using JoinInputs =
    SetFields<&RegistrationCase::title, &RegistrationCase::centerlineFile, &RegistrationCase::vesselInput,
              &RegistrationCase::volume, &RegistrationCase::scanIdentity, &RegistrationCase::tree,
              &RegistrationCase::auxiliaryBranchIds, &RegistrationCase::excludedBranchIds, &RegistrationCase::imageFile,
              &RegistrationCase::angiogram, &RegistrationCase::frame, &RegistrationCase::targetFile,
              &RegistrationCase::givenTarget, &RegistrationCase::cArm, &RegistrationCase::cameraOverride,
              &RegistrationCase::hasInitialPose, &RegistrationCase::cameraFromPatient, &RegistrationCase::result>;

/// The edit that makes the document's case like `wanted`, geometry only.
std::unique_ptr<QUndoCommand> changeGeometry(CaseDocument& document, const RegistrationCase& wanted,
                                             const QString& text);

/// The edit that takes over the inputs of `wanted` and all that hangs on them.
std::unique_ptr<QUndoCommand> joinInputs(CaseDocument& document, const RegistrationCase& wanted, const QString& text);

}   // namespace app
