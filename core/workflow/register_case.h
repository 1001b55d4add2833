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
    /// All: all views jointly; Loaded: all views with a loaded image, jointly; Shown: only the shown view.
    enum class Views { All, Loaded, Shown };

    Views views = Views::All;
    std::optional<Centerline2d> shownTarget{};   ///< target of the shown view; if not set, the view is traced.
                                                 /// The method `wire` ignores it if devices are marked (see targetOf).
    double readMs = StageTimes::notMeasured;   ///< time for reading the case; stored with the result
    std::string author{};   ///< person who requested the registration; stored with the result
    std::string time{};   ///< time of the request, ISO 8601, UTC; stored with the result
};

/// A case after registration.
struct RegisteredCase {
    Case session;   ///< every registered view with its pose and result; the shown view's result holds for all jointly
    std::vector<std::size_t> viewIndices;   ///< indices of the registered views in `session.views`, the shown one first
    std::vector<Centerline2d> targets;   ///< targets of these views, in the same order
    std::optional<MultiViewResult> joint;   ///< joint result, if several views were registered
    std::shared_ptr<const Case> asked{};   ///< case before registration

    const RegistrationResult& result() const { return *session.shown().result; }
};

/// Applies a result to the view: sets its pose and marks the view as changed from its case file.
void applyRegistration(View& view, RegistrationResult result);

/// Applies the pose and result of a view of a registered case, and the geometry if the registration estimated it.
void applyRegistration(View& view, const View& registered);

/// Registers a case; the main entry point. Traces the vessels in each view, registers the tree to one view
/// (registerVessels) or to all views jointly (registerViews), and applies the result. If the images contradict the
/// geometry and the options request it, the estimated geometry is used. Images of different patients, or of opposite
/// body sides, give an unreliable result unless the user confirmed the patient (View::isSamePatient). The error names
/// the view and the missing input. If the user cancels, returns a cancellation before a pose was found, and afterwards
/// the best pose.
Result<RegisteredCase> registerCase(Case session, RegistrationPlan plan = {}, const WorkObserver& observe = {});

}   // namespace angiopose::core
