#include "io/opening/view_from_inputs.h"

#include "core/case/relative_view_pose.h"
#include "io/messages/messages.h"
#include "io/opening/assemble_case.h"

namespace angiopose::io {
namespace {

/// Returns a view of the case's vessels with the opened image, at its initial pose.
core::View viewWithImage(const core::Case& session, const LoadedInputs& inputs)
{
    core::Case blank = session;
    blank.shown() = {};
    LoadedInputs imageOnly;
    imageOnly.angiogram = inputs.angiogram;
    imageOnly.storedRun = inputs.storedRun;
    imageOnly.imageFile = inputs.imageFile;
    imageOnly.headerPlan = inputs.headerPlan;
    imageOnly.target = inputs.target;
    imageOnly.targetFile = inputs.targetFile;
    return assembleCase(std::move(blank), imageOnly).shown();
}

}   // namespace

core::Result<core::View> viewFromInputs(const core::Case& session, const LoadedInputs& inputs, const std::string& path)
{
    if (inputs.loadedCase && inputs.loadedCase->shown().angiogram) {
        core::View view = inputs.loadedCase->shown();
        view.caseFile = {path, {}};
        core::discardResults(view);   // the findings of the other case were obtained with other vessels
        return view;
    }
    if (!inputs.angiogram) {
        return core::Error(messages::openNoAngiogram().about(path));
    }
    const core::View& shown = session.shown();
    core::View view = viewWithImage(session, inputs);
    if (const auto fromShown = core::relativeViewPose(shown, view, session.vessels)) {
        view.cameraFromPatient = fromShown.value().viewFromFirst * shown.cameraFromPatient;
        if (shown.initialCameraFromPatient) {   // the coordinate axes of the vessels may be unrelated to the gantry
                                                // angles from which the initial pose was computed
            view.initialCameraFromPatient = fromShown.value().viewFromFirst * *shown.initialCameraFromPatient;
        }
    }
    return view;
}

}   // namespace angiopose::io
