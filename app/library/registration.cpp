#include "angiopose/registration.h"
#include "app/library/case_content.h"
#include "app/library/conversions.h"
#include "app/library/observer_adapter.h"
#include "core/case/registration_input.h"
#include "core/workflow/register_case.h"
#include "io/pose_file.h"

namespace angiopose::library {
namespace {

/// Throws if the view has no initial pose, since registration would otherwise start from the identity matrix.
void requireInitialPose(const core::View& view, const core::Vessels& vessels)
{
    if (auto start = core::initialPoseOf(view, vessels); !start) {
        throw Error("library.no-start",
                    "The geometry of the angiogram gives no initial pose; set one. " + start.error().message.text());
    }
}

core::RegistrationInput coreInputOf(const core::Case& values)
{
    requireInitialPose(values.shown(), values.vessels);
    return valueOf(core::makeRegistrationInput(values, valueOf(core::targetOf(values.shown(), values.options.method))));
}

/// Throws if a view with an image lacks an initial pose; the registration itself reports views without an image.
void requireInitialPoses(const core::Case& values)
{
    for (const core::View& view : values.views) {
        if (view.angiogram) {
            requireInitialPose(view, values.vessels);
        }
    }
}

core::RegisteredCase registered(const core::Case& values, ObserverAdapter& relay)
{
    return relay.resultOf(core::registerCase(values, {}, relay.working()));
}

}   // namespace

StopReason toPublic(core::StopReason reason)
{
    switch (reason) {
        case core::StopReason::Converged:
            return StopReason::Converged;
        case core::StopReason::NoImprovement:
            return StopReason::NoImprovement;
        case core::StopReason::StoppedByUser:
            return StopReason::StoppedByUser;
        default:
            return StopReason::IterationLimit;
    }
}

// Lists every member, so that the compiler reports an error when core adds one.
DistanceMetrics toPublic(const core::DistanceMetrics& metrics)
{
    const auto& [meanPx, medianPx, p75Px, p95Px, meanMm, medianMm, p75Mm, p95Mm, coverage, reversePx, reverseMm] =
        metrics;
    return {meanPx, medianPx, p75Px, p95Px, meanMm, medianMm, p75Mm, p95Mm, coverage, reversePx, reverseMm};
}

BranchResidual toPublic(const core::BranchResidual& branch)
{
    const auto& [id, pointCount, medianPx, p95Px, agreement] = branch;
    return {id, pointCount, medianPx, p95Px, agreement};
}

Hypothesis toPublic(const core::Hypothesis& hypothesis)
{
    const auto& [cameraFromPatient, score] = hypothesis;
    return {library::toPublic(cameraFromPatient), score};
}

WirePath toPublic(const core::WirePath& path)
{
    return {path.branchIds, path.tipInPatient,  path.probability,
            path.offAxisMm, path.followedShare, library::toPublic(path.cameraFromPatient)};
}

namespace {

template <class Core, class... Context>
auto eachPublic(const std::vector<Core>& all, const Context&... context)
{
    std::vector<decltype(toPublic(all.front(), context...))> converted;
    converted.reserve(all.size());
    for (const Core& each : all) {
        converted.push_back(toPublic(each, context...));
    }
    return converted;
}

std::shared_ptr<const core::ImageF> sharedImage(const Image& image)
{
    return image.isEmpty() ? nullptr : std::make_shared<const core::ImageF>(toCore(image));
}

}   // namespace

core::RegistrationInput toCore(const RegistrationInput& input)
{
    core::RegistrationInput converted;
    converted.tree = toCore(input.tree);
    converted.target = toCore(input.target);
    converted.camera = toCore(input.camera);
    converted.initialCameraFromPatient = toCore(input.initialCameraFromPatient);
    converted.auxiliaryBranchIds = input.auxiliaryBranchIds;
    converted.excludedBranchIds = input.excludedBranchIds;
    converted.image = sharedImage(input.image);
    converted.polarity = toCore(input.polarity);
    converted.volume = input.volume ? input.volume->content() : nullptr;
    if (input.lockReference) {
        converted.lockReference = toCore(*input.lockReference);
    }
    converted.lockPivotInPatient = input.lockPivotInPatient;
    return converted;
}

RegistrationInput toPublic(const core::RegistrationInput& input)
{
    RegistrationInput converted;
    converted.tree = toPublic(input.tree);
    converted.target = toPublic(input.target);
    converted.camera = toPublic(input.camera);
    converted.initialCameraFromPatient = toPublic(input.initialCameraFromPatient);
    converted.auxiliaryBranchIds = input.auxiliaryBranchIds;
    converted.excludedBranchIds = input.excludedBranchIds;
    if (input.image) {
        converted.image = toPublic(core::ImageF(*input.image));
    }
    converted.polarity = toPublic(input.polarity);
    if (input.volume) {
        converted.volume.emplace(input.volume);
    }
    if (input.lockReference) {
        converted.lockReference = toPublic(*input.lockReference);
    }
    converted.lockPivotInPatient = input.lockPivotInPatient;
    return converted;
}

PoseUncertainty toPublic(const core::PoseUncertainty& uncertainty, const core::VesselTree& tree)
{
    const auto& [covariance, imageCovariance, rotationDeg, inPlaneMm, depthMm, observed, weakestDirection] =
        uncertainty;
    return {core::centroidInPatient(tree), covariance, rotationDeg, inPlaneMm, depthMm, observed, weakestDirection};
}

RegistrationResult toPublic(const core::RegistrationResult& result, const core::VesselTree& tree)
{
    RegistrationResult converted;
    converted.method = result.method;
    converted.cameraFromPatient = toPublic(result.cameraFromPatient);
    converted.stopReason = toPublic(result.stopReason);
    converted.iterations = result.iterations;
    converted.metrics = toPublic(result.metrics);
    converted.uncertainty = toPublic(result.uncertainty, tree);
    converted.branches = eachPublic(result.branches);
    converted.alternatives = eachPublic(result.alternatives);
    converted.wirePaths = eachPublic(result.wirePaths);
    if (result.deformed) {
        converted.deformed = toPublic(*result.deformed, tree);
    }
    converted.trustworthy = result.trustworthy;
    converted.probabilityWithin2Mm = result.probabilityWithin2Mm;
    converted.warnings = toPublic(result.warnings);
    converted.totalMs = result.time.totalMs;
    return converted;
}

MultiViewResult toPublic(const core::MultiViewResult& result, const core::VesselTree& tree)
{
    return {eachPublic(result.views, tree),
            {result.corrections.begin(), result.corrections.end()},
            toPublic(result.uncertainty, tree),
            result.deformed ? std::optional(toPublic(*result.deformed, tree)) : std::nullopt,
            result.trustworthy,
            toPublic(result.warnings)};
}

}   // namespace angiopose::library

namespace angiopose {

RegistrationResult registerVessels(const RegistrationInput& input, const RegistrationOptions& options,
                                   const Observer& observe)
{
    const core::RegistrationInput problem = library::toCore(input);
    library::ObserverAdapter relay(observe);
    return library::toPublic(
        relay.resultOf(core::registerVessels(problem, library::toCore(options), relay.iterations())), problem.tree);
}

RegistrationResult evaluatePose(const RegistrationInput& input, const Pose& cameraFromPatient)
{
    const core::RegistrationInput problem = library::toCore(input);
    return library::toPublic(library::valueOf(core::evaluatePose(problem, library::toCore(cameraFromPatient))),
                             problem.tree);
}

MultiViewResult registerViews(const std::vector<RegistrationInput>& views, const RegistrationOptions& options,
                              const Observer& observe)
{
    std::vector<core::RegistrationInput> inputs;
    inputs.reserve(views.size());
    for (const RegistrationInput& view : views) {
        inputs.push_back(library::toCore(view));
    }
    library::ObserverAdapter relay(observe);
    core::MultiViewResult joint =
        relay.resultOf(core::registerViews(inputs, library::toCore(options), {}, relay.iterations()));
    return library::toPublic(joint, inputs.front().tree);   // not empty: registerViews fails for fewer than two views
}

std::string toText(StopReason reason)
{
    for (const core::StopReason each : {core::StopReason::Converged, core::StopReason::IterationLimit,
                                        core::StopReason::NoImprovement, core::StopReason::StoppedByUser}) {
        if (library::toPublic(each) == reason) {
            return std::string(core::toText(each));
        }
    }
    return {};
}

Pose readPose(const std::string& path)
{
    return library::toPublic(library::valueOf(io::readPose(path)));
}

void writePose(const Pose& cameraFromPatient, const std::string& path)
{
    library::check(io::writePose(library::toCore(cameraFromPatient), path));
}

}   // namespace angiopose

namespace angiopose {

Centerline2d targetOf(const Case& session)
{
    return library::toPublic(library::valueOf(core::targetOf(session.content().values.shown())));
}

RegistrationInput inputOf(const Case& session)
{
    return library::toPublic(library::coreInputOf(session.content().values));
}

RegistrationResult registerCase(Case& session, const Observer& observe)
{
    core::Case& values = session.content().values;
    if (values.views.size() > 1) {
        throw Error("library.several-views", "The case has " + std::to_string(session.viewCount()) +
                                                 " views of the vessels. Register them jointly with registerViews.");
    }
    library::requireInitialPoses(values);
    library::ObserverAdapter relay(observe);
    values = library::registered(values, relay).session;
    return library::toPublic(*values.shown().result, *values.vessels.tree);
}

MultiViewResult registerViews(Case& session, const Observer& observe)
{
    core::Case& values = session.content().values;
    if (values.views.size() < 2) {
        throw Error("library.one-view", "The case has one view of the vessels. Register it with registerCase.");
    }
    library::requireInitialPoses(values);
    library::ObserverAdapter relay(observe);
    core::RegisteredCase run = library::registered(values, relay);
    values = std::move(run.session);
    return library::toPublic(*run.joint, *values.vessels.tree);
}

}   // namespace angiopose
