#pragma once

#include "core/case/case.h"
#include "core/registration/register_views.h"
#include "core/workflow/observer.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace angiopose::core {

/// What of a case is registered.
struct RegistrationPlan {
    /// All: every view, together. Loaded: likewise, without those whose image is not there. Shown: that one alone.
    enum class Views { All, Loaded, Shown };

    Views views = Views::All;
    std::optional<Centerline2d> shownTarget{};   ///< vessels of the shown view where they are known; else traced.
                                                 /// A wire kept apart comes first (see targetOf).
    double readMs = StageTimes::notMeasured;   ///< what reading the case took; kept with the result
    std::string author{};   ///< who asks for it; kept with the result
    std::string time{};   ///< when, ISO 8601, UTC; kept with the result
};

/// A case after its registration.
struct RegisteredCase {
    Case session;   ///< every registered view with its pose and its result; the shown view's holds for all together
    std::vector<std::size_t> places;   ///< of the registered views in `session.views`, the shown one first
    std::vector<Centerline2d> targets;   ///< what they were registered to, in the same order
    std::optional<MultiViewResult> joint;   ///< of several views
    std::shared_ptr<const Case> asked{};   ///< the case as it was before

    const RegistrationResult& result() const { return *session.shown().result; }
};

/// The view after a run that found this: at its pose, and no longer as its case file has it.
void takeOver(View& view, RegistrationResult result);

/// Likewise of a view of a registered case, with the geometry that the run may have estimated.
void takeOver(View& view, const View& registered);

/// The main job: traces the vessels in each view, registers the tree to one view (registerVessels) or to all together
/// (registerViews), and takes over what was found; where images contradict the geometry and the options want that, with
/// the geometry that they show. Images of different patients, or of opposite sides, give no result to be trusted
/// unless somebody made sure (View::isSamePatient).
/// Fails naming the view and what it lacks. Stopped before there is any
/// pose it ends as stopped, later it keeps the best pose.
Result<RegisteredCase> registerCase(Case session, RegistrationPlan plan = {}, const WorkObserver& observe = {});

}   // namespace angiopose::core
