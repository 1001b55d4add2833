#include "app/editing/curve_tracing_controller.h"

#include "app/document/edit_case.h"
#include "ui/actions/window_actions.h"
#include "ui/panels/angiogram_panel.h"
#include "ui/views/angiogram_view.h"

namespace angiopose::app {

CurveTracingController::CurveTracingController(const AngiogramParts& parts, QObject* parent)
    : QObject(parent),
      document_(parts.document),
      target_(parts.target),
      actions_(parts.actions),
      panel_(parts.panel),
      view_(parts.view)
{
    connect(&panel_, &ui::AngiogramPanel::tracingEdited, this, &CurveTracingController::change);
    connect(&document_, &CaseDocument::changed, this, [this] {
        const core::View& shown = document_.current().shown();
        panel_.showTracing(shown.traceOptions, core::traceOptionsOf(shown).maxVesselRadiusPx);
    });
    connect(&target_, &TargetProvider::changed, this, &CurveTracingController::showExcludedRegions);
    connect(&view_, &ui::AngiogramView::toolChanged, this, &CurveTracingController::showExcludedRegions);
    connect(actions_[ui::Command::ShowTrace], &QAction::toggled, this, &CurveTracingController::showExcludedRegions);
}

void CurveTracingController::change(const core::TraceOptions& options, const ui::LocalizedText& undoText)
{
    document_.push(
        std::make_unique<ChangeTracing>(document_, ChangeTracing::Values{options, std::nullopt, {}}, undoText));
}

/// Shows the image regions excluded from tracing while the curves are displayed or edited.
void CurveTracingController::showExcludedRegions()
{
    const bool isLooking =
        actions_[ui::Command::ShowTrace]->isChecked() || actions_[ui::Command::EditVessels]->isChecked();
    const SharedTrace wanted = isLooking ? target_.trace() : nullptr;
    if (wanted != shownTrace_) {
        shownTrace_ = wanted;
        view_.setExcludedArea(wanted ? wanted->fieldMask : core::Mask2d{});
    }
}

}   // namespace angiopose::app
