#include "core/workflow/register_case.h"

#include "core/case/case_patients.h"
#include "core/case/case_views.h"
#include "core/case/estimated_geometry.h"
#include "core/case/registration_input.h"
#include "core/messages/messages.h"
#include "core/registration/deformable/deformed_tree.h"
#include "core/support/stopwatch.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace angiopose::core {
namespace {

constexpr double tracingShare = 0.1;   // fraction of the progress for tracing, if any view must be traced
constexpr int maxEstimates = 3;   // maximum number of geometry estimates; most cases converge by the second
constexpr double firstShare = 0.7;   // share of the remaining progress for the first registration, often the only one

Result<std::vector<std::size_t>> plannedViews(const Case& session, RegistrationPlan::Views views)
{
    if (views == RegistrationPlan::Views::Shown) {
        return std::vector{session.shownView};
    }
    for (const View& view : session.views) {
        if (views == RegistrationPlan::Views::All && !view.angiogram) {
            const std::string& path = view.imageFile.path.empty() ? view.caseFile.path : view.imageFile.path;
            return Error(messages::viewImageUnreadable().about(path));
        }
    }
    return registeredViews(session);
}

/// Names the image file in the error if there are several views.
Error about(const Error& error, const View& view, std::size_t viewCount)
{
    return viewCount > 1 && !error.isCancellation() ? error.about(view.imageFile.path) : error;
}

/// Targets of the registered views and tracing times (NaN if the target was known).
struct TracedViews {
    std::vector<Centerline2d> targets;
    std::vector<double> durationsMs;
};

Result<TracedViews> traceViews(const Case& session, const std::vector<std::size_t>& viewIndices,
                               std::optional<Centerline2d> shownTarget, ProgressReporter& progress)
{
    TracedViews traced;
    const double share = tracingShare / static_cast<double>(viewIndices.size());
    for (std::size_t k = 0; k < viewIndices.size(); ++k) {
        progress.enter(share * static_cast<double>(k), share * static_cast<double>(k + 1), viewIndices[k]);
        const View& view = session.views[viewIndices[k]];
        const bool isWire = session.options.method == "wire" && devicesOf(view);
        if (k == 0 && shownTarget && !isWire) {
            traced.targets.push_back(*std::move(shownTarget));
            traced.durationsMs.push_back(StageTimes::notMeasured);
            continue;
        }
        if (progress.report("tracing", 0.0) == ObserverDecision::Stop) {
            return Cancellation{messages::stoppedBeforeRun()};
        }
        Stopwatch watch;
        auto target = targetOf(view, session.options.method);
        if (!target) {
            return about(target.error(), view, viewIndices.size());
        }
        traced.targets.push_back(std::move(target).value());
        traced.durationsMs.push_back(watch.takeLapMs());
    }
    return traced;
}

/// A part of the progress, from `first` to `last` as fractions of the whole.
struct Part {
    double first;
    double last;
};

/// Returns an observer that forwards the solver's reports on these views as one part of the progress.
IterationObserver solverObserver(ProgressReporter& progress, const std::vector<std::size_t>& viewIndices,
                                 const Part& part)
{
    return [&progress, &viewIndices, part](const IterationReport& report) {
        progress.enter(part.first, part.last, viewIndices[report.view]);
        return progress.report(report.stage, report.progress, &report);
    };
}

/// Returns the result of one view. The first view gets the joint uncertainty, because the other views determine its
/// depth. If the joint result is unreliable, the results of all views are.
RegistrationResult resultWithJointRating(const MultiViewResult& joint, std::size_t view)
{
    RegistrationResult result = joint.views[view];
    if (view > 0 && joint.trustworthy) {
        return result;
    }
    result.uncertainty = view == 0 ? joint.uncertainty : result.uncertainty;
    result.trustworthy = joint.trustworthy;
    for (const Message& warning : joint.warnings) {
        if (std::ranges::find(result.warnings, warning) == result.warnings.end()) {
            result.warnings.push_back(warning);
        }
    }
    return result;
}

/// Data stored with every result of a registration in addition to the solver's output.
struct RunMetadata {
    Provenance provenance;
    double readMs;
    std::vector<double> traceMs;   ///< one per registered view

    void addTo(RegistrationResult& result, std::size_t number, const View& view) const
    {
        result.provenance = provenance;
        result.provenance.frame = view.frame;
        result.time.readMs = readMs;
        result.time.traceMs = traceMs[number];
    }
};

/// Registers a single view. Camera uncertainties, if given, replace those that follow from the origins.
Status registerOne(RegisteredCase& run, const RunMetadata& notes, std::span<const CameraUncertainty> uncertainties,
                   const IterationObserver& observe)
{
    auto asked = makeRegistrationInput(run.session, run.targets.front());
    if (!asked) {
        return asked.error();
    }
    RegistrationInput input = std::move(asked).value();
    if (!uncertainties.empty()) {
        input.cameraUncertainty = uncertainties.front();
    }
    auto found =
        registerVessels(input, optionsFor(run.session.shown(), run.session.vessels, run.session.options), observe);
    if (!found) {
        return found.error();
    }
    RegistrationResult result = std::move(found).value();
    notes.addTo(result, 0, run.session.shown());
    applyRegistration(run.session.shown(), std::move(result));
    return Done{};
}

Status registerJointly(RegisteredCase& run, const RunMetadata& notes, std::span<const CameraUncertainty> uncertainties,
                       const IterationObserver& observe)
{
    Stopwatch watch;
    MultiViewOptions multiView;
    for (const std::size_t viewIndex : run.viewIndices) {
        multiView.numbers.push_back(viewIndex + 1);
    }
    auto asked = makeJointInputs(viewsAt(run.session, run.viewIndices), run.session.vessels, run.targets, multiView);
    if (!asked) {
        return asked.error();
    }
    JointInputs inputs = std::move(asked).value();
    for (std::size_t k = 0; k < uncertainties.size(); ++k) {
        inputs.views[k].cameraUncertainty = uncertainties[k];
    }
    auto joint = registerViews(inputs.views, optionsFor(run.session.shown(), run.session.vessels, run.session.options),
                               inputs.multiView, observe);
    if (!joint) {
        return joint.error();
    }
    run.joint = std::move(joint).value();
    run.joint->warnings.insert(run.joint->warnings.begin(), inputs.notes.begin(), inputs.notes.end());
    const double totalMs = watch.takeLapMs();   // common to all views, which were registered jointly
    for (std::size_t k = 0; k < run.viewIndices.size(); ++k) {
        RegistrationResult& result = run.joint->views[k];
        result.time.totalMs = totalMs;
        notes.addTo(result, k, run.session.views[run.viewIndices[k]]);
        RegistrationResult viewResult = resultWithJointRating(*run.joint, k);
        if (!run.joint->cameras.empty()) {
            viewResult.camera = run.joint->cameras[k];
        }
        if (run.joint->deformed) {
            viewResult.deformed = std::make_shared<const DeformableResult>(withViewFirst(*run.joint->deformed, k));
        }
        applyRegistration(run.session.views[run.viewIndices[k]], std::move(viewResult));
    }
    return Done{};
}

Status registerPlanned(RegisteredCase& run, const RunMetadata& notes, std::span<const CameraUncertainty> uncertainties,
                       const IterationObserver& observe)
{
    return run.viewIndices.size() > 1 ? registerJointly(run, notes, uncertainties, observe)
                                      : registerOne(run, notes, uncertainties, observe);
}

/// Poses and camera uncertainties of the planned views before registration, and the camera corrections made since.
class GeometryCorrection {
public:
    explicit GeometryCorrection(const RegisteredCase& run)
    {
        for (const std::size_t viewIndex : run.viewIndices) {
            const View& view = run.session.views[viewIndex];
            starts_.push_back(view.cameraFromPatient);
            uncertainties_.push_back(cameraUncertaintyOf(view));
        }
    }

    const std::vector<CameraUncertainty>& uncertainties() const { return uncertainties_; }

    /// Applies the cameras estimated from the images and resets the poses to those before registration; returns false
    /// if the views already have these cameras.
    bool correct(RegisteredCase& run)
    {
        bool isChanged = false;
        for (std::size_t k = 0; k < run.viewIndices.size(); ++k) {
            if (const auto error = applyEstimatedGeometry(run.session.views[run.viewIndices[k]])) {
                uncertainties_[k].appliedError += *error;
                isChanged = true;
            }
        }
        for (std::size_t k = 0; isChanged && k < run.viewIndices.size(); ++k) {
            run.session.views[run.viewIndices[k]].cameraFromPatient = starts_[k];
        }
        return isChanged;
    }

    /// Adds a note about the camera corrections to the results that depend on them.
    void report(RegisteredCase& run) const
    {
        for (std::size_t k = 0; k < uncertainties_.size(); ++k) {
            const CameraError& appliedError = uncertainties_[k].appliedError;
            if (appliedError.isZero()) {
                continue;
            }
            const Message note = messages::cameraEstimated(Quantity{100.0 * std::exp(appliedError[0]), 1, "%"},
                                                           static_cast<int>(std::lround(appliedError[1])),
                                                           static_cast<int>(std::lround(appliedError[2])))
                                     .as(Severity::Note);
            run.session.views[run.viewIndices[k]].result->warnings.push_back(note);
            if (run.joint) {
                run.joint->warnings.push_back(messages::inView(run.viewIndices[k] + 1, note).as(Severity::Note));
            }
        }
    }

private:
    std::vector<RigidTransform> starts_;
    std::vector<CameraUncertainty> uncertainties_;
};

/// Marks the results as unreliable, whatever the fit, if the images come from different patients or opposite sides.
void flagPatientMismatch(RegisteredCase& run)
{
    Case registered;
    registered.vessels.scanIdentity = run.session.vessels.scanIdentity;
    registered.views.clear();
    for (const std::size_t viewIndex : run.viewIndices) {
        if (!run.session.views[viewIndex].isSamePatient) {
            registered.views.push_back(run.session.views[viewIndex]);
        }
    }
    Messages mismatch = findMismatch(registered);
    std::erase_if(mismatch, [](const Message& note) { return note.is(messages::examinationOfRunsDiffers); });
    if (mismatch.empty()) {
        return;
    }
    for (const std::size_t viewIndex : run.viewIndices) {
        RegistrationResult& result = *run.session.views[viewIndex].result;
        result.trustworthy = false;
        result.probabilityWithin2Mm.reset();
        result.warnings.insert(result.warnings.begin(), mismatch.begin(), mismatch.end());
    }
    if (run.joint) {
        run.joint->trustworthy = false;
        run.joint->warnings.insert(run.joint->warnings.begin(), mismatch.begin(), mismatch.end());
    }
}

bool isStopped(const RegisteredCase& run)
{
    return run.result().stopReason == StopReason::StoppedByUser;
}

/// Whether the images contradict the geometry of any view.
bool isContradicted(const RegisteredCase& run)
{
    return std::ranges::any_of(run.viewIndices, [&run](std::size_t viewIndex) {
        return isGeometryContradicted(run.session.views[viewIndex], run.viewIndices.size());
    });
}

/// Registers the case, and repeats this with the geometry estimated from the images as long as the images contradict
/// the current one. An estimate that does not lead to a reliable fit is discarded, because a wrong pose implies a wrong
/// geometry.
Status registerWithEstimation(RegisteredCase& run, const RunMetadata& notes, ProgressReporter& progress, double begin)
{
    GeometryCorrection geometry(run);
    const double firstEnd = begin + firstShare * (1.0 - begin);
    const Status first = registerPlanned(run, notes, {}, solverObserver(progress, run.viewIndices, {begin, firstEnd}));
    if (!first || !isContradicted(run)) {
        return first;
    }
    const RegisteredCase uncorrected = run;
    for (int round = 0; round < maxEstimates && !isStopped(run) && geometry.correct(run); ++round) {
        const double step = (1.0 - firstEnd) / maxEstimates;
        const Part part{firstEnd + round * step, firstEnd + (round + 1) * step};
        const Status again =
            registerPlanned(run, notes, geometry.uncertainties(), solverObserver(progress, run.viewIndices, part));
        if (!again) {
            return again.error();
        }
    }
    if (run.result().trustworthy) {
        geometry.report(run);
    } else {
        run = uncorrected;
    }
    return Done{};
}

}   // namespace

void applyRegistration(View& view, const View& registered)
{
    view.geometry = registered.geometry;
    applyRegistration(view, *registered.result);
}

void applyRegistration(View& view, RegistrationResult result)
{
    discardResults(view);
    view.caseFile = {};
    view.cameraFromPatient = result.cameraFromPatient;
    view.result = std::move(result);
}

Result<RegisteredCase> registerCase(Case session, RegistrationPlan plan, const WorkObserver& observe)
{
    const bool isTraced = !plan.shownTarget;
    auto viewIndices = plannedViews(session, plan.views);
    if (!viewIndices) {
        return viewIndices.error();
    }
    ProgressReporter progress(observe);
    auto traced = traceViews(session, viewIndices.value(), std::move(plan.shownTarget), progress);
    if (!traced) {
        return traced.error();
    }
    auto asked = std::make_shared<const Case>(session);
    RegisteredCase run{
        std::move(session), std::move(viewIndices).value(), std::move(traced).value().targets, {}, std::move(asked)};
    const double begin = isTraced || run.viewIndices.size() > 1 ? tracingShare : 0.0;
    const RunMetadata notes{{std::move(plan.author), std::move(plan.time), ANGIOPOSE_VERSION, run.session.options},
                            plan.readMs,
                            traced.value().durationsMs};
    const Status status =
        run.session.options.geometry.estimate
            ? registerWithEstimation(run, notes, progress, begin)
            : registerPlanned(run, notes, {}, solverObserver(progress, run.viewIndices, {begin, 1.0}));
    if (!status) {
        return status.error();
    }
    flagPatientMismatch(run);
    for (const std::size_t viewIndex : run.viewIndices) {
        run.session.views[viewIndex].result->provenance.start = run.asked->views[viewIndex].cameraFromPatient;
    }
    return run;
}

}   // namespace angiopose::core
