#include "app/views/view_controller.h"

#include "app/document/edit_case.h"
#include "app/words/view_words.h"
#include "core/case/case_views.h"
#include "ui/actions/window_actions.h"
#include "ui/panels/registration_panel.h"
#include "ui/panels/view_strip.h"
#include "ui/words/message_text.h"
#include "ui/words/number.h"
#include "ui/words/spoken.h"

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
      looking_([this](const std::vector<ViewLook>& looks) { showPictures(looks); })
{
    pause_.setSingleShot(true);
    pause_.setInterval(250ms);
    connect(&pause_, &QTimer::timeout, this, &ViewController::look);
    connect(&document_, &CaseDocument::changed, this, &ViewController::followDocument);
    connect(&target_, &TargetProvider::changed, this, &ViewController::followDocument);
    connect(&document_, &CaseDocument::stateChanged, this, &ViewController::followDocument);
    connectWindow();
    ui::speak(this, [this] { followDocument(); });
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

void ViewController::openMenu(int line, const QPoint& at)
{
    auto* menu = new QMenu(&ui_.dialogParent);
    menu->setObjectName(QStringLiteral("viewMenu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addAction(tr("Show this view"), this, [this, line] { show(line); });
    menu->addAction(tr("Name this view…"), this, [this, line] { askName(line); });
    menu->addAction(tr("Remove this view"), this, [this, line] { remove(line); });
    menu->popup(at);
}

void ViewController::followDocument()
{
    const core::Case& current = document_.current();
    const core::Vessels& vessels = current.vessels;
    const bool hasImage = current.shown().angiogram != nullptr;
    const bool areSeveral = current.views.size() > 1 && hasImage;
    ui_.actions[ui::Command::NextView]->setEnabled(areSeveral && !document_.isInTrial());
    ui_.actions[ui::Command::AddView]->setEnabled(hasImage && vessels.tree && !document_.isInTrial());
    ui_.panel.setEnabled(!document_.isLocked() && !document_.isInTrial());
    ui_.registration.showViewCount(areSeveral ? static_cast<int>(core::registeredViews(current).size()) : 1);
    lineCount_ = areSeveral ? current.views.size() : 0;
    showLines();
    Seen seen;
    if (areSeveral) {
        seen = {vessels.tree, vessels.excludedBranchIds, vessels.hiddenBranchIds, {}, target_.current()};
        std::ranges::transform(current.views, std::back_inserter(seen.views), sightOf);
    }
    if (seen != seen_) {
        seen_ = seen;
        if (areSeveral) {
            pause_.start();
        } else {
            looks_.clear();   // the summaries belong to the previous case
        }
    }
}

const ViewLook* ViewController::lookOf(std::size_t place) const
{
    const core::Case& current = document_.current();
    const core::View& view = current.views[place];
    const auto found =
        std::ranges::find_if(looks_, [&](const ViewLook& look) {   // for the shown view: the last known summary
            return place == current.shownView ? look.of.angiogram == view.angiogram : look.of == sightOf(view);
        });
    return found == looks_.end() || !view.angiogram ? nullptr : &*found;
}

void ViewController::showLines()
{
    const core::Case& current = document_.current();
    std::vector<ui::ViewLine> lines;
    for (std::size_t place = 0; place < lineCount_; ++place) {
        const core::View& view = current.views[place];
        const ViewLook* look = lookOf(place);
        QString agreement;
        if (look && look->metrics) {
            agreement = tr("%1 mm · %2 px")
                            .arg(ui::numberText(look->metrics->medianMm, 2))
                            .arg(ui::numberText(look->metrics->medianPx, 1));
        } else {
            agreement = view.angiogram ? QStringLiteral("…") : tr("not found");
        }
        const QString problem = look ? ui::messageText(look->problem) : QString();
        lines.push_back({numberedTitle(current.views, place) + QLatin1Char('\n') + agreement,
                         problem.isEmpty()
                             ? tr("%1. Click to show it; Delete removes the active view.").arg(fileNameOf(view))
                             : fileNameOf(view) + QStringLiteral(": ") + problem});
    }
    ui_.panel.showViews(lines, static_cast<int>(current.shownView));
}

void ViewController::look()
{
    if (looking_.isRunning()) {
        pause_.start();
        return;
    }
    if (seen_.views.empty()) {
        return;
    }
    looking_.start([snapshot = document_.current(), target = target_.current(), known = looks_,
                    widthPx = ui_.panel.pictureWidthPx()](JobLink<double>&) -> core::Result<std::vector<ViewLook>> {
        return lookAtViews(snapshot, target, known, widthPx);
    });
}

void ViewController::showPictures(std::vector<ViewLook> looks)
{
    if (seen_.views.empty()) {
        return;   // the case has been closed in the meantime
    }
    looks_ = std::move(looks);
    showLines();
    for (std::size_t place = 0; place < lineCount_; ++place) {
        const ViewLook* look = lookOf(place);
        if (look && look->picture) {
            ui_.panel.showPicture(static_cast<int>(place), *look->picture);
        }
    }
    emit looked();
}

std::shared_ptr<const core::Centerline2d> ViewController::targetOf(std::size_t place) const
{
    return knownTarget(looks_, sightOf(document_.current().views[place]));
}

void ViewController::show(int line)
{
    const auto place = static_cast<std::size_t>(line);
    const core::Case& current = document_.current();
    if (place == current.shownView) {
        return;
    }
    const core::View& view = current.views[place];
    if (!view.angiogram) {
        emit refused(tr("The image of this view could not be read."));
    } else {
        document_.push(showView(document_, core::showingView(current, place),
                                [name = numberedTitle(current.views, place)] { return tr("Show view %1").arg(name); }));
    }
    showLines();   // resets the selection in the strip if the view was refused
}

void ViewController::showNext()
{
    if (lineCount_ > 0) {
        show(static_cast<int>((document_.current().shownView + 1) % lineCount_));
    }
}

void ViewController::askName(int line)
{
    const auto place = static_cast<std::size_t>(line);
    auto* dialog = new QInputDialog(&ui_.dialogParent);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Name this view"));
    dialog->setLabelText(tr("Name of the view %1 (empty: its angles)").arg(anglesOf(document_.current().views[place])));
    dialog->setTextValue(QString::fromStdString(document_.current().views[place].name));
    connect(dialog, &QInputDialog::textValueSelected, this, [this, place](const QString& name) {
        core::Case named = document_.current();
        if (place < named.views.size() && !document_.isLocked()) {
            named.views[place].name = name.trimmed().toStdString();
            document_.push(showView(document_, named, [] { return tr("Rename view"); }));
        }
    });
    dialog->open();
}

void ViewController::remove(int line)
{
    const core::Case& current = document_.current();
    const core::Case without = core::withoutView(current, static_cast<std::size_t>(line));
    if (without.views.size() == current.views.size()) {
        emit refused(tr("No other view can be shown in its place."));
        return;
    }
    document_.push(showView(document_, without, [] { return tr("Remove view"); }));
}

}   // namespace angiopose::app
