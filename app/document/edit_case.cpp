#include "app/document/edit_case.h"

namespace app {

std::unique_ptr<QUndoCommand> changeGeometry(CaseDocument& document, const RegistrationCase& wanted,
                                             const QString& text)
{
    return std::make_unique<ChangeGeometry>(
        document, ChangeGeometry::Values{wanted.cArm, wanted.cameraOverride, wanted.cameraFromPatient, wanted.result},
        text);
}

std::unique_ptr<QUndoCommand> joinInputs(CaseDocument& document, const RegistrationCase& wanted, const QString& text)
{
    return std::make_unique<JoinInputs>(document,
                                        JoinInputs::Values{wanted.title,
                                                           wanted.centerlineFile,
                                                           wanted.vesselInput,
                                                           wanted.volume,
                                                           wanted.scanIdentity,
                                                           wanted.tree,
                                                           wanted.auxiliaryBranchIds,
                                                           wanted.excludedBranchIds,
                                                           wanted.imageFile,
                                                           wanted.angiogram,
                                                           wanted.storedRun,
                                                           wanted.headerPlan,
                                                           wanted.treatment,
                                                           wanted.frame,
                                                           wanted.targetFile,
                                                           wanted.givenTarget,
                                                           wanted.editedFrame,
                                                           wanted.acceptedCurveIds,
                                                           wanted.cArm,
                                                           wanted.cameraOverride,
                                                           wanted.hasInitialPose,
                                                           wanted.cameraFromPatient,
                                                           wanted.result},
                                        text);
}

}   // namespace app
