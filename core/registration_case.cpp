#include "core/registration_case.h"

#include "core/geometry/geometry_checks.h"
#include "core/messages/says.h"

namespace angiopose::core {

Result<ProjectionCamera> cameraOf(const RegistrationCase& registrationCase)
{
    if (registrationCase.cameraOverride) {
        if (const auto problem = findProblem(*registrationCase.cameraOverride)) {
            return Error(*problem);
        }
        return *registrationCase.cameraOverride;
    }
    if (!registrationCase.angiogram) {
        return Error(says::noAngiogram());
    }
    return cameraFromCArm(registrationCase.cArm, registrationCase.angiogram->width(),
                          registrationCase.angiogram->height());
}

Messages contradictionsOf(const RegistrationCase& registrationCase)
{
    if (!registrationCase.angiogram || registrationCase.cameraOverride) {
        return {};
    }
    const Angiogram& angiogram = *registrationCase.angiogram;
    return findContradictions(registrationCase.cArm, angiogram.gantry, {angiogram.width(), angiogram.height()});
}

std::optional<Eigen::Vector3d> pivotInPatient(const RegistrationCase& registrationCase)
{
    if (!registrationCase.tree) {
        return std::nullopt;
    }
    return registrationCase.pickedPivotInPatient.value_or(centroidInPatient(*registrationCase.tree));
}

CArm cArmOfFrame(const RegistrationCase& registrationCase)
{
    if (!registrationCase.angiogram) {
        return registrationCase.cArm;
    }
    const auto& increments = registrationCase.angiogram->gantry.angleIncrementsDeg;
    const auto frame = static_cast<std::size_t>(registrationCase.frame);
    return registrationCase.frame >= 0 && frame < increments.size() ? turnedBy(registrationCase.cArm, increments[frame])
                                                                    : registrationCase.cArm;
}

namespace {

Result<RigidTransform> poseFromAngles(const RegistrationCase& registrationCase)
{
    const auto& isocentre = registrationCase.cArm.isocentreInPatientMm.value;
    if (!isocentre && !registrationCase.tree) {
        return Error(says::noVesselTree());
    }
    return cameraFromPatient(cArmOfFrame(registrationCase),
                             isocentre ? *isocentre : centroidInPatient(*registrationCase.tree));
}

}   // namespace

Result<RigidTransform> startPoseOf(const RegistrationCase& registrationCase)
{
    if (registrationCase.hasInitialPose) {
        return registrationCase.initialCameraFromPatient;
    }
    return poseFromAngles(registrationCase);
}

RegistrationCase withFrame(RegistrationCase registrationCase, int frame)
{
    const auto before = poseFromAngles(registrationCase);
    registrationCase.frame = frame;
    const bool turns = registrationCase.angiogram && !registrationCase.angiogram->gantry.angleIncrementsDeg.empty();
    const auto after = poseFromAngles(registrationCase);
    if (!turns || !before || !after) {
        return registrationCase;
    }
    const RigidTransform laterFromEarlier = after.value() * before.value().inverse();
    registrationCase.cameraFromPatient = laterFromEarlier * registrationCase.cameraFromPatient;
    registrationCase.initialCameraFromPatient = laterFromEarlier * registrationCase.initialCameraFromPatient;
    registrationCase.result.reset();
    return registrationCase;
}

const std::shared_ptr<const Angiogram>& storedRunOf(const RegistrationCase& registrationCase)
{
    return registrationCase.storedRun ? registrationCase.storedRun : registrationCase.angiogram;
}

std::shared_ptr<const Centerline2d> givenTargetOf(const RegistrationCase& registrationCase)
{
    const bool holds = !registrationCase.editedFrame || registrationCase.editedFrame == registrationCase.frame;
    return holds ? registrationCase.givenTarget : nullptr;
}

Result<Centerline2d> targetOf(const RegistrationCase& registrationCase)
{
    if (const auto given = givenTargetOf(registrationCase)) {
        return *given;
    }
    if (!registrationCase.angiogram || registrationCase.angiogram->frames.empty()) {
        return Error(says::noAngiogram());
    }
    auto trace = traceFrame(*registrationCase.angiogram, registrationCase.frame, registrationCase.traceOptions);
    if (!trace) {
        return trace.error();
    }
    return std::move(trace).value().centerline;
}

namespace {

/// The frame as the image methods read it; null where there is none that the camera takes.
std::shared_ptr<const ImageF> imageOf(const RegistrationCase& registrationCase, const ProjectionCamera& camera)
{
    const auto& angiogram = registrationCase.angiogram;
    const int frame = registrationCase.frame;
    const bool isTaken = angiogram && frame >= 0 && frame < angiogram->frameCount() &&
                         angiogram->width() == camera.width && angiogram->height() == camera.height;
    if (!isTaken) {
        return nullptr;
    }
    return {angiogram, &angiogram->frames[static_cast<std::size_t>(frame)]};
}

}   // namespace

Result<RegistrationInput> registrationInputOf(const RegistrationCase& registrationCase, Centerline2d target)
{
    if (!registrationCase.tree) {
        return Error(says::noVesselTree());
    }
    auto camera = cameraOf(registrationCase);
    if (!camera) {
        return camera.error();
    }
    RegistrationInput input;
    input.tree = *registrationCase.tree;
    input.target = std::move(target);
    input.camera = camera.value();
    input.initialCameraFromPatient = registrationCase.cameraFromPatient;
    if (const auto start = startPoseOf(registrationCase)) {
        input.lockReference = start.value();
    }
    input.lockPivotInPatient = registrationCase.pickedPivotInPatient;
    input.auxiliaryBranchIds = registrationCase.auxiliaryBranchIds;
    input.excludedBranchIds = registrationCase.excludedBranchIds;
    input.image = imageOf(registrationCase, input.camera);
    if (input.image) {
        input.polarity = registrationCase.angiogram->polarity;
    }
    input.volume = registrationCase.volume;
    return input;
}

}   // namespace angiopose::core