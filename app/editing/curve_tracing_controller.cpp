#include "app/editing/curve_tracing_controller.h"

#include "app/document/edit_case.h"
#include "ui/main_window.h"
#include "ui/views/angiogram_view.h"

namespace angiopose::app {

CurveTracingController::CurveTracingController(const AngiogramParts& parts, QObject* parent)
    : QObject(parent), document_(parts.document), target_(parts.target), window_(parts.window)
{
    connect(&window_.angiogramPanel(), &ui::AngiogramPanel::tracingEdited, this, &CurveTracingController::change);
    connect(&document_, &CaseDocument::changed, this,
            [this] { window_.angiogramPanel().showTracing(document_.current().shown().traceOptions); });
    connect(&target_, &TargetProvider::changed, this, &CurveTracingController::showKeptOut);
    connect(&window_.angiogramView(), &ui::AngiogramView::toolChanged, this, &CurveTracingController::showKeptOut);
    connect(window_.actions()[ui::Command::ShowTrace], &QAction::toggled, this, &CurveTracingController::showKeptOut);
}

void CurveTracingController::change(const core::TraceOptions& options, const ui::Words& what)
{
    document_.push(std::make_unique<ChangeTracing>(document_, ChangeTracing::Values{options, std::nullopt}, what));
}

/// Whoever looks at the curves wants to see where none can be.
void CurveTracingController::showKeptOut()
{
    const bool isLooking = window_.actions()[ui::Command::ShowTrace]->isChecked() ||
                           window_.actions()[ui::Command::EditVessels]->isChecked();
    const SharedTrace wanted = isLooking ? target_.trace() : nullptr;
    if (wanted != shownTrace_) {
        shownTrace_ = wanted;
        window_.angiogramView().setKeptOut(wanted ? wanted->fieldMask : core::Mask2d{});
    }
}

}   // namespace angiopose::app