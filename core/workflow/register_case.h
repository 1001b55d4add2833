#pragma once

#include "core/case/case.h"
#include "core/registration/register_views.h"
#include "core/workflow/observer.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace angiopose::core {

/// Options for registering a case.
struct RegistrationPlan {
    /// All: all views jointly. Loaded: all views with a loaded image. Shown: only the shown view.
    enum class Views { All, Loaded, Shown };

    Views views = Views::All;
    std::optional<Centerline2d> shownTarget{};   ///< known target of the shown view; otherwise it is traced
                                                 /// Method `wire` uses separated devices first (see targetOf).
    double readMs = StageTimes::notMeasured;   ///< time for reading the case; stored with the result
    std::string author{};   ///< person who requests it; stored with the result
    std::string time{};   ///< time of the request, ISO 8601, UTC; stored with the result
};

/// A case after its registration.
struct RegisteredCase {
    Case session;   ///< every registered view with its pose and result; the shown view's result holds for all jointly
    std::vector<std::size_t> places;   ///< indices of the registered views in `session.views`, the shown one first
    std::vector<Centerline2d> targets;   ///< their targets, in the same order
    std::optional<MultiViewResult> joint;   ///< joint result of several views
    std::shared_ptr<const Case> asked{};   ///< the case before registration

    const RegistrationResult& result() const { return *session.shown().result; }
};

/// Applies a result to the view: sets its pose and marks the view as changed from its case file.
void takeOver(View& view, RegistrationResult result);

/// Same for a view of a registered case, including the geometry that the registration may have estimated.
void takeOver(View& view, const View& registered);

/// Main entry point: traces the vessels in each view, registers the tree to one view (registerVessels) or to all
/// jointly (registerViews), and applies the result. If the images contradict the geometry and the options request it,
/// the estimated geometry is used. Images of different patients, or of opposite sides, give an unreliable result unless
/// the user confirmed the patient (View::isSamePatient). Fails naming the view and the missing input. If stopped before
/// any pose was found, returns Stopped; later, it keeps the best pose.
Result<RegisteredCase> registerCase(Case session, RegistrationPlan plan = {}, const WorkObserver& observe = {});

}   // namespace angiopose::core
