#include "core/case/registration_input.h"

#include "core/case/relative_view_pose.h"
#include "core/messages/messages.h"
#include "core/registration/problem/in_view.h"
#include "core/registration/problem/registration_problem.h"
#include "core/registration/register_views.h"

#include <cassert>
#include <utility>

namespace angiopose::core {
namespace {

/// Returns the frame for the image-based methods; null if no frame matches the camera.
std::shared_ptr<const ImageF> imageOf(const View& view, const ProjectionCamera& camera)
{
    const auto& angiogram = view.angiogram;
    const bool matchesCamera = angiogram && view.frame >= 0 && view.frame < angiogram->frameCount() &&
                               angiogram->width() == camera.width && angiogram->height() == camera.height;
    if (!matchesCamera) {
        return nullptr;
    }
    return {angiogram, &angiogram->frames[static_cast<std::size_t>(view.frame)]};
}

}   // namespace

RegistrationOptions optionsFor(const View& view, const Vessels& vessels, RegistrationOptions options)
{
    constexpr double objectPlaneMm = 55.0;   // 1-σ of the object plane that a device assumes, relative to the vessels
    double& depthMm = options.angiopose.priorDepthMm;
    const CArm& cArm = view.geometry.cArm;
    const bool isAtObjectPlane = !view.initialCameraFromPatient && isAtInitialPose(view, vessels) &&
                                 !cArm.isocenterInPatientMm.value && &vesselDepthOf(cArm) == &cArm.sourceToObjectMm;
    if (isAtObjectPlane && depthMm == AngioPoseOptions().priorDepthMm) {
        depthMm = objectPlaneMm;
    }
    return options;
}

Result<RegistrationInput> makeRegistrationInput(const View& view, const Vessels& vessels, Centerline2d target)
{
    if (!vessels.tree) {
        return Error(messages::noVesselTree());
    }
    auto camera = cameraOf(view);
    if (!camera) {
        return camera.error();
    }
    RegistrationInput input;
    input.tree = *vessels.tree;
    input.target = std::move(target);
    input.camera = camera.value();
    input.cameraUncertainty = cameraUncertaintyOf(view);
    input.initialCameraFromPatient = view.cameraFromPatient;
    if (const auto start = initialPoseOf(view, vessels)) {
        input.lockReference = start.value();
    }
    input.lockPivotInPatient = vessels.pickedPivotInPatient;
    input.auxiliaryBranchIds = vessels.auxiliaryBranchIds;
    input.excludedBranchIds = vessels.excludedBranchIds;
    input.image = imageOf(view, input.camera);
    if (input.image) {
        input.polarity = view.angiogram->polarity;
        input.shutter = {view.angiogram, &view.angiogram->shutter};
    }
    input.volume = vessels.scan;
    input.tableAngles = tableAnglesOf(view);
    return input;
}

Result<RegistrationInput> makeRegistrationInput(const Case& session, Centerline2d target)
{
    auto input = makeRegistrationInput(session.shown(), session.vessels, std::move(target));
    if (!input) {
        return input;
    }
    RegistrationInput shownInput = std::move(input).value();
    shownInput.cameraUncertainty = cameraUncertaintyFor(shownInput.cameraUncertainty, session.options.geometry);
    return shownInput;
}

Result<JointInputs> makeJointInputs(std::span<const View> views, const Vessels& vessels,
                                    std::span<const Centerline2d> targets, MultiViewOptions multiView)
{
    assert(views.size() == targets.size());
    JointInputs inputs;
    multiView.steps.assign(views.size(), {});
    for (std::size_t k = 0; k < views.size(); ++k) {
        View view = views[k];
        if (k > 0) {
            const auto step = relativeViewPose(views.front(), view, vessels);
            if (!step) {
                return inView(multiView.viewNumber(k), step.error());
            }
            view.cameraFromPatient = step.value().viewFromFirst * views.front().cameraFromPatient;
            multiView.steps[k] = step.value().spread;
            for (const Message& note : step.value().notes) {
                inputs.notes.push_back(messages::inView(multiView.viewNumber(k), note).as(note.severity()));
            }
        }
        auto input = makeRegistrationInput(view, vessels, targets[k]);
        if (!input) {
            return inView(multiView.viewNumber(k), input.error());
        }
        inputs.views.push_back(std::move(input).value());
    }
    inputs.multiView = std::move(multiView);
    return inputs;
}

}   // namespace angiopose::core
