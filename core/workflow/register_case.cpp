#include "core/workflow/register_case.h"

#include "core/case/case_views.h"
#include "core/case/registration_input.h"
#include "core/messages/says.h"
#include "core/registration/deformable/bent_tree.h"
#include "core/support/stopwatch.h"

#include <algorithm>
#include <utility>

namespace angiopose::core {
namespace {

constexpr double tracingShare = 0.1;   // of the whole, where something has to be traced

Result<std::vector<std::size_t>> plannedViews(const Case& theCase, RegistrationPlan::Views views)
{
    if (views == RegistrationPlan::Views::Shown) {
        return std::vector{theCase.shownView};
    }
    for (const View& view : theCase.views) {
        if (views == RegistrationPlan::Views::All && !view.angiogram) {
            const std::string& path = view.imageFile.path.empty() ? view.caseFile.path : view.imageFile.path;
            return Error(says::viewImageUnread().about(path));
        }
    }
    return registeredViews(theCase);
}

/// What a view lacks is said of its file where there are several.
Error about(const Error& error, const View& view, std::size_t viewCount)
{
    return viewCount > 1 && !error.isStop() ? error.about(view.imageFile.path) : error;
}

/// The vessels of the views that are registered, and what finding them took (NaN where they were known).
struct TracedViews {
    std::vector<Centerline2d> targets;
    std::vector<double> tookMs;
};

Result<TracedViews> traceViews(const Case& theCase, const std::vector<std::size_t>& places,
                               std::optional<Centerline2d> shownTarget, Course& course)
{
    TracedViews traced;
    const double share = tracingShare / static_cast<double>(places.size());
    for (std::size_t k = 0; k < places.size(); ++k) {
        course.enter(share * static_cast<double>(k), share * static_cast<double>(k + 1), places[k]);
        if (k == 0 && shownTarget) {
            traced.targets.push_back(*std::move(shownTarget));
            traced.tookMs.push_back(StageTimes::notMeasured);
            continue;
        }
        if (course.tell("tracing", 0.0) == Verdict::Stop) {
            return Stopped{says::stoppedBeforeRun()};
        }
        Stopwatch watch;
        auto target = targetOf(theCase.views[places[k]]);
        if (!target) {
            return about(target.error(), theCase.views[places[k]], places.size());
        }
        traced.targets.push_back(std::move(target).value());
        traced.tookMs.push_back(watch.lapMs());
    }
    return traced;
}

/// What a solver says of the views at `places` goes to the course, as its part from `first` to the end.
IterationObserver solverObserver(Course& course, const std::vector<std::size_t>& places, double first)
{
    return [&course, &places, first](const IterationReport& report) {
        course.enter(first, 1.0, places[report.view]);
        return course.tell(report.stage, report.progress, &report);
    };
}

/// What holds for all views together belongs to the shown one: its depth is known from the others.
RegistrationResult resultOfAll(const MultiViewResult& joint)
{
    RegistrationResult result = joint.views.front();
    result.uncertainty = joint.uncertainty;
    result.camera = joint.cameras.empty() ? std::nullopt : std::optional(joint.cameras.front());
    result.trustworthy = joint.trustworthy;
    for (const Message& warning : joint.warnings) {
        if (std::ranges::find(result.warnings, warning) == result.warnings.end()) {
            result.warnings.push_back(warning);
        }
    }
    return result;
}

/// What every result of a run keeps besides what was found.
struct RunNotes {
    Provenance provenance;
    double readMs;
    std::vector<double> traceMs;   ///< of each registered view

    void addTo(RegistrationResult& result, std::size_t number, const View& view) const
    {
        result.provenance = provenance;
        result.provenance.frame = view.frame;
        result.time.readMs = readMs;
        result.time.traceMs = traceMs[number];
    }
};

Status registerOne(RegisteredCase& run, const RunNotes& notes, const IterationObserver& observe)
{
    const auto input = registrationInputOf(run.theCase, run.targets.front());
    if (!input) {
        return input.error();
    }
    auto found = registerVessels(input.value(), run.theCase.options, observe);
    if (!found) {
        return found.error();
    }
    RegistrationResult result = std::move(found).value();
    notes.addTo(result, 0, run.theCase.shown());
    takeOver(run.theCase.shown(), std::move(result));
    return Done{};
}

Status registerTogether(RegisteredCase& run, const RunNotes& notes, const IterationObserver& observe)
{
    Stopwatch watch;
    MultiViewOptions multiView;
    for (const std::size_t place : run.places) {
        multiView.numbers.push_back(place + 1);
    }
    const auto inputs = jointInputsOf(viewsAt(run.theCase, run.places), run.theCase.vessels, run.targets, multiView);
    if (!inputs) {
        return inputs.error();
    }
    auto joint = registerViews(inputs.value(), run.theCase.options, multiView, observe);
    if (!joint) {
        return joint.error();
    }
    run.joint = std::move(joint).value();
    const double totalMs = watch.lapMs();   // one run found them all
    for (std::size_t k = 0; k < run.places.size(); ++k) {
        RegistrationResult& result = run.joint->views[k];
        result.time.totalMs = totalMs;
        notes.addTo(result, k, run.theCase.views[run.places[k]]);
        RegistrationResult kept = k == 0 ? resultOfAll(*run.joint) : result;
        if (run.joint->bent) {
            kept.bent = std::make_shared<const DeformableResult>(seenFirst(*run.joint->bent, k));
        }
        takeOver(run.theCase.views[run.places[k]], std::move(kept));
    }
    return Done{};
}

}   // namespace

void takeOver(View& view, RegistrationResult result)
{
    view.caseFile = {};
    view.cameraFromPatient = result.cameraFromPatient;
    view.result = std::move(result);
}

Result<RegisteredCase> registerCase(Case theCase, RegistrationPlan plan, const WorkObserver& observe)
{
    const bool isTraced = !plan.shownTarget;
    auto places = plannedViews(theCase, plan.views);
    if (!places) {
        return places.error();
    }
    Course course(observe);
    auto traced = traceViews(theCase, places.value(), std::move(plan.shownTarget), course);
    if (!traced) {
        return traced.error();
    }
    RegisteredCase run{std::move(theCase), std::move(places).value(), std::move(traced).value().targets, {}};
    const double begin = isTraced || run.places.size() > 1 ? tracingShare : 0.0;
    const IterationObserver observer = solverObserver(course, run.places, begin);
    const RunNotes notes{{std::move(plan.author), std::move(plan.time), ANGIOPOSE_VERSION, run.theCase.options},
                         plan.readMs,
                         traced.value().tookMs};
    const Status status =
        run.places.size() > 1 ? registerTogether(run, notes, observer) : registerOne(run, notes, observer);
    if (!status) {
        return status.error();
    }
    return run;
}

}   // namespace angiopose::core
