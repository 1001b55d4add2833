#include "app/editing/opacification_controller.h"

#include "ui/actions/window_actions.h"
#include "ui/panels/bottom_strip.h"
#include "ui/plots/opacification_plot.h"

#include <QDialog>
#include <QVBoxLayout>

namespace angiopose::app {

OpacificationController::OpacificationController(const AngiogramParts& parts, QObject* parent)
    : QObject(parent),
      document_(parts.document),
      sync_(parts.sync),
      strip_(parts.strip),
      dialogParent_(parts.dialogParent)
{
    connect(parts.actions[ui::Command::Opacification], &QAction::triggered, this, &OpacificationController::open);
    connect(&strip_, &ui::BottomStrip::plotRequested, this, &OpacificationController::open);
    connect(&document_, &CaseDocument::changed, this, &OpacificationController::show);
    connect(&sync_, &ViewSync::opacificationMeasured, this, &OpacificationController::show);
    connect(&sync_, &ViewSync::frameShown, this, [this](int frame) {
        if (plot_) {
            plot_->showCurrent(frame);
        }
    });
}

void OpacificationController::open()
{
    if (plot_) {
        plot_->window()->raise();
        return;
    }
    auto* dialog = new QDialog(&dialogParent_);
    dialog->setObjectName(QStringLiteral("opacificationDialog"));
    dialog->setWindowTitle(tr("Opacification over time"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    plot_ = new ui::OpacificationPlot;
    auto* layout = new QVBoxLayout(dialog);
    layout->addWidget(plot_);
    connect(plot_, &ui::OpacificationPlot::frameRequested, &strip_, &ui::BottomStrip::frameRequested);
    show();
    dialog->show();   // non-modal, so that frames can be selected in both the dialog and the window
}

void OpacificationController::show()
{
    if (!plot_) {
        return;
    }
    const core::SubtractionPlan& plan = document_.current().shown().processing.plan;
    plot_->showFrames(sync_.frameCurve());
    plot_->showMasks(plan.interval             ? std::vector<int>()
                     : plan.maskFrames.empty() ? sync_.suggestedMasks()
                                               : plan.maskFrames);
    plot_->showCurrent(sync_.shownFrame());
}

}   // namespace angiopose::app
