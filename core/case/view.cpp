#include "core/case/view.h"

#include "core/geometry/geometry_checks.h"
#include "core/messages/messages.h"
#include "core/tracing/angiogram/frame/widest_vessel.h"

namespace angiopose::core {

const RegistrationResult* resultOfShownFrame(const View& view)
{
    return view.result && view.result->provenance.frame.value_or(view.frame) == view.frame ? &*view.result : nullptr;
}

void discardResults(View& view)
{
    view.result.reset();
    view.followed = {};
}

Result<ProjectionCamera> cameraOf(const View& view)
{
    if (const auto& camera = view.geometry.cameraOverride) {
        if (const auto problem = findProblem(*camera)) {
            return Error(*problem);
        }
        const auto& run = view.angiogram;
        if (run && (run->width() != camera->width || run->height() != camera->height)) {
            return Error(messages::cameraImageSizeMismatch(camera->width, camera->height, run->width(), run->height()));
        }
        return *camera;
    }
    if (!view.angiogram) {
        return Error(messages::noAngiogram());
    }
    return cameraFromCArm(view.geometry.cArm, view.angiogram->width(), view.angiogram->height());
}

CameraUncertainty cameraUncertaintyOf(const View& view)
{
    const auto camera = cameraOf(view);
    if (!camera) {
        return {};
    }
    return view.geometry.cameraOverride ? enteredCameraUncertainty(camera.value())
                                        : uncertaintyByOrigin(view.geometry.cArm, camera.value());
}

std::optional<TableAngles> tableAnglesOf(const View& view)
{
    if (!view.angiogram || !view.angiogram->gantry.patientPosition || view.geometry.cameraOverride ||
        view.initialCameraFromPatient) {
        return {};
    }
    const CArm cArm = cArmOfFrame(view);
    const bool isFromHeader =
        cArm.primaryAngleDeg.origin == Origin::Header && cArm.secondaryAngleDeg.origin == Origin::Header;
    return isFromHeader ? anglesFromTable(cArm, *view.angiogram->gantry.patientPosition) : std::nullopt;
}

Messages contradictionsOf(const View& view)
{
    if (!view.angiogram || view.geometry.cameraOverride) {
        return {};
    }
    const Angiogram& angiogram = *view.angiogram;
    return findContradictions(view.geometry.cArm, angiogram.gantry, {angiogram.width(), angiogram.height()});
}

CArm cArmOfFrame(const View& view)
{
    const CArm& cArm = view.geometry.cArm;
    if (!view.angiogram) {
        return cArm;
    }
    const auto& increments = view.angiogram->gantry.angleIncrementsDeg;
    const auto frame = static_cast<std::size_t>(view.frame);
    return view.frame >= 0 && frame < increments.size() ? rotateCArm(cArm, increments[frame]) : cArm;
}

const std::shared_ptr<const Angiogram>& storedRunOf(const View& view)
{
    return view.storedRun ? view.storedRun : view.angiogram;
}

std::shared_ptr<const Centerline2d> givenTargetOf(const View& view)
{
    const bool isForFrame = !view.target.editedFrame || view.target.editedFrame == view.frame;
    return isForFrame ? view.target.centerline : nullptr;
}

std::shared_ptr<const Centerline2d> devicesOf(const View& view)
{
    const bool isForFrame = view.target.editedFrame == view.frame;
    return isForFrame ? view.target.devices : nullptr;
}

SeparatedCurves curvesOf(const GivenTarget& target)
{
    SeparatedCurves apart;
    apart.vessels = target.centerline ? *target.centerline : Centerline2d{};
    apart.devices = target.devices ? *target.devices : Centerline2d{};
    return apart;
}

Result<Centerline2d> targetOf(const View& view, const std::string& method)
{
    const auto devices = devicesOf(view);
    return devices && method == "wire" ? Result<Centerline2d>(*devices) : targetOf(view);
}

TraceOptions traceOptionsOf(const View& view)
{
    return view.angiogram ? resolveOptions(view.traceOptions, view.geometry.cArm, view.angiogram->width(),
                                           view.angiogram->height())
                          : view.traceOptions;
}

Result<Centerline2d> targetOf(const View& view)
{
    if (const auto given = givenTargetOf(view)) {
        return *given;
    }
    if (!view.angiogram || view.angiogram->frames.empty()) {
        return Error(messages::noAngiogram());
    }
    auto trace = traceFrame(*view.angiogram, view.frame, traceOptionsOf(view));
    if (!trace) {
        return trace.error();
    }
    return std::move(trace).value().centerline;
}

}   // namespace angiopose::core
