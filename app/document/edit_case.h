#pragma once

#include "app/document/case_document.h"
#include "app/document/set_fields.h"

#include <QString>

#include <memory>

namespace app {

using core::RegistrationCase;

/// A hand edit of the pose: what the last run said no longer holds.
using MovePose = SetFields<&RegistrationCase::cameraFromPatient, &RegistrationCase::result>;

using ShowFrame = SetFields<&RegistrationCase::frame>;
using ChooseAuxiliary = SetFields<&RegistrationCase::auxiliaryBranchIds>;
using ExcludeBranches = SetFields<&RegistrationCase::excludedBranchIds, &RegistrationCase::result>;
using ChangeOptions = SetFields<&RegistrationCase::options>;
using ChangeGeometry = SetFields<&RegistrationCase::cArm, &RegistrationCase::cameraOverride,
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
              &RegistrationCase::volume, &RegistrationCase::scanIdentity, &RegistrationCase::tree,
              &RegistrationCase::auxiliaryBranchIds, &RegistrationCase::excludedBranchIds, &RegistrationCase::imageFile,
              &RegistrationCase::angiogram, &RegistrationCase::storedRun, &RegistrationCase::headerPlan,
              &RegistrationCase::treatment, &RegistrationCase::frame, &RegistrationCase::targetFile,
              &RegistrationCase::givenTarget, &RegistrationCase::editedFrame, &RegistrationCase::acceptedCurveIds,
              &RegistrationCase::cArm, &RegistrationCase::cameraOverride, &RegistrationCase::hasInitialPose,
              &RegistrationCase::cameraFromPatient, &RegistrationCase::result>;

/// The edit that makes the document's case like `wanted`, geometry only.
std::unique_ptr<QUndoCommand> changeGeometry(CaseDocument& document, const RegistrationCase& wanted,
                                             const QString& text);

/// The edit that takes over the inputs of `wanted` and all that hangs on them.
std::unique_ptr<QUndoCommand> joinInputs(CaseDocument& document, const RegistrationCase& wanted, const QString& text);

}   // namespace app
