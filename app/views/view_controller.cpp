#include "app/views/view_controller.h"

#include "app/document/edit_case.h"
#include "app/words/view_words.h"
#include "core/case/case_views.h"
#include "ui/actions/window_actions.h"
#include "ui/panels/registration_panel.h"
#include "ui/panels/view_strip.h"
#include "ui/words/message_text.h"
#include "ui/words/number.h"
#include "ui/words/retranslation.h"

#include <QInputDialog>
#include <QMenu>

#include <algorithm>
#include <chrono>

namespace angiopose::app {
namespace {

using namespace std::chrono_literals;

}   // namespace

ViewController::ViewController(CaseDocument& document, const TargetProvider& target, const Ui& ui, QObject* parent)
    : QObject(parent),
      document_(document),
      target_(target),
      ui_(ui),
      summaryJob_([this](const std::vector<ViewSummary>& summaries) { showThumbnails(summaries); })
{
    delayTimer_.setSingleShot(true);
    delayTimer_.setInterval(250ms);
    connect(&delayTimer_, &QTimer::timeout, this, &ViewController::look);
    connect(&document_, &CaseDocument::changed, this, &ViewController::updateFromDocument);
    connect(&target_, &TargetProvider::changed, this, &ViewController::updateFromDocument);
    connect(&document_, &CaseDocument::stateChanged, this, &ViewController::updateFromDocument);
    connectWindow();
    ui::keepTranslated(this, [this] { updateFromDocument(); });
}

void ViewController::connectWindow()
{
    const ui::WindowActions& actions = ui_.actions;
    ui::ViewStrip& strip = ui_.panel;
    connect(&strip, &ui::ViewStrip::viewPicked, this, &ViewController::show);
    connect(&strip, &ui::ViewStrip::removeRequested, this, &ViewController::remove);
    connect(&strip, &ui::ViewStrip::addRequested, actions[ui::Command::AddView], &QAction::trigger);
    connect(&strip, &ui::ViewStrip::menuRequested, this, &ViewController::openMenu);
    connect(actions[ui::Command::NextView], &QAction::triggered, this, &ViewController::showNext);
}

void ViewController::openMenu(int row, const QPoint& at)
{
    auto* menu = new QMenu(&ui_.dialogParent);
    menu->setObjectName(QStringLiteral("viewMenu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addAction(tr("Show this view"), this, [this, row] { show(row); });
    menu->addAction(tr("Name this view…"), this, [this, row] { askForName(row); });
    menu->addAction(tr("Remove this view"), this, [this, row] { remove(row); });
    menu->popup(at);
}

void ViewController::updateFromDocument()
{
    const core::Case& current = document_.current();
    const core::Vessels& vessels = current.vessels;
    const bool hasImage = current.shown().angiogram != nullptr;
    const bool areSeveral = current.views.size() > 1 && hasImage;
    ui_.actions[ui::Command::NextView]->setEnabled(areSeveral && !document_.isInTrial());
    ui_.actions[ui::Command::AddView]->setEnabled(hasImage && vessels.tree && !document_.isInTrial());
    ui_.panel.setEnabled(!document_.isLocked() && !document_.isInTrial());
    ui_.registration.showViewCount(areSeveral ? static_cast<int>(core::registeredViews(current).size()) : 1);
    rowCount_ = areSeveral ? current.views.size() : 0;
    showRows();
    SummaryInputs inputs;
    if (areSeveral) {
        inputs = {vessels.tree, vessels.excludedBranchIds, vessels.hiddenBranchIds, {}, target_.current()};
        std::ranges::transform(current.views, std::back_inserter(inputs.views), viewKey);
    }
    if (inputs != summaryInputs_) {
        summaryInputs_ = inputs;
        if (areSeveral) {
            delayTimer_.start();
        } else {
            summaries_.clear();   // the summaries belong to the previous case
        }
    }
}

const ViewSummary* ViewController::summaryOf(std::size_t viewIndex) const
{
    const core::Case& current = document_.current();
    const core::View& view = current.views[viewIndex];
    const auto found =
        std::ranges::find_if(summaries_, [&](const ViewSummary& look) {   // for the shown view, the last known summary
            return viewIndex == current.shownView ? look.key.angiogram == view.angiogram : look.key == viewKey(view);
        });
    return found == summaries_.end() || !view.angiogram ? nullptr : &*found;
}

void ViewController::showRows()
{
    const core::Case& current = document_.current();
    std::vector<ui::ViewRow> lines;
    for (std::size_t viewIndex = 0; viewIndex < rowCount_; ++viewIndex) {
        const core::View& view = current.views[viewIndex];
        const ViewSummary* look = summaryOf(viewIndex);
        QString agreement;
        if (look && look->metrics) {
            agreement = tr("%1 mm · %2 px")
                            .arg(ui::numberText(look->metrics->medianMm, 2))
                            .arg(ui::numberText(look->metrics->medianPx, 1));
        } else {
            agreement = view.angiogram ? QStringLiteral("…") : tr("not found");
        }
        const QString problem = look ? ui::messageText(look->problem) : QString();
        lines.push_back({numberedTitle(current.views, viewIndex) + QLatin1Char('\n') + agreement,
                         problem.isEmpty()
                             ? tr("%1. Click to show this view; Delete removes the active view.").arg(fileNameOf(view))
                             : fileNameOf(view) + QStringLiteral(": ") + problem});
    }
    ui_.panel.showViews(lines, static_cast<int>(current.shownView));
}

void ViewController::look()
{
    if (summaryJob_.isRunning()) {
        delayTimer_.start();
        return;
    }
    if (summaryInputs_.views.empty()) {
        return;
    }
    summaryJob_.start(
        [snapshot = document_.current(), target = target_.current(), known = summaries_,
         widthPx = ui_.panel.thumbnailWidthPx()](JobLink<double>&) -> core::Result<std::vector<ViewSummary>> {
            return summarizeViews(snapshot, target, known, widthPx);
        });
}

void ViewController::showThumbnails(std::vector<ViewSummary> summaries)
{
    if (summaryInputs_.views.empty()) {
        return;   // the case has been closed in the meantime
    }
    summaries_ = std::move(summaries);
    showRows();
    for (std::size_t viewIndex = 0; viewIndex < rowCount_; ++viewIndex) {
        const ViewSummary* look = summaryOf(viewIndex);
        if (look && look->picture) {
            ui_.panel.showThumbnail(static_cast<int>(viewIndex), *look->picture);
        }
    }
    emit summariesReady();
}

std::shared_ptr<const core::Centerline2d> ViewController::targetOf(std::size_t viewIndex) const
{
    return cachedTarget(summaries_, viewKey(document_.current().views[viewIndex]));
}

void ViewController::show(int row)
{
    const auto viewIndex = static_cast<std::size_t>(row);
    const core::Case& current = document_.current();
    if (viewIndex == current.shownView) {
        return;
    }
    const core::View& view = current.views[viewIndex];
    if (!view.angiogram) {
        emit refused(tr("The image of this view could not be read."));
    } else {
        document_.push(
            showView(document_, core::withShownView(current, viewIndex),
                     [name = numberedTitle(current.views, viewIndex)] { return tr("Show view %1").arg(name); }));
    }
    showRows();   // resets the selection in the strip if the view was refused
}

void ViewController::showNext()
{
    if (rowCount_ > 0) {
        show(static_cast<int>((document_.current().shownView + 1) % rowCount_));
    }
}

void ViewController::askForName(int row)
{
    const auto viewIndex = static_cast<std::size_t>(row);
    auto* dialog = new QInputDialog(&ui_.dialogParent);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Name this view"));
    dialog->setLabelText(
        tr("Name of view %1 (leave empty to use its angles)").arg(anglesOf(document_.current().views[viewIndex])));
    dialog->setTextValue(QString::fromStdString(document_.current().views[viewIndex].name));
    connect(dialog, &QInputDialog::textValueSelected, this, [this, viewIndex](const QString& name) {
        core::Case named = document_.current();
        if (viewIndex < named.views.size() && !document_.isLocked()) {
            named.views[viewIndex].name = name.trimmed().toStdString();
            document_.push(showView(document_, named, [] { return tr("Rename view"); }));
        }
    });
    dialog->open();
}

void ViewController::remove(int row)
{
    const core::Case& current = document_.current();
    const core::Case without = core::withoutView(current, static_cast<std::size_t>(row));
    if (without.views.size() == current.views.size()) {
        emit refused(tr("No other view can be shown instead."));
        return;
    }
    document_.push(showView(document_, without, [] { return tr("Remove view"); }));
}

}   // namespace angiopose::app
