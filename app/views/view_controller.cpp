#include "app/views/view_controller.h"

#include "app/document/edit_case.h"
#include "app/jobs/future_result.h"
#include "app/texts/number_text.h"
#include "core/case_views.h"
#include "ui/main_window.h"
#include "ui/panels/view_strip.h"
#include "ui/words/message_text.h"
#include "ui/words/number.h"
#include "ui/words/spoken.h"

#include <QFileInfo>
#include <QMenu>
#include <QtConcurrentRun>

#include <algorithm>
#include <chrono>
#include <numeric>
#include <tuple>

namespace angiopose::app {
namespace {

using namespace std::chrono_literals;

const core::RegistrationCase* viewAt(const core::RegistrationCase& current, std::size_t place)
{
    return place == 0 ? &current : current.otherViews[place - 1].view.get();
}

/// Lines keep their places whichever view is shown: sorted by angles, then by file.
std::vector<std::size_t> lineOrder(const core::RegistrationCase& current)
{
    std::vector<std::size_t> order(current.otherViews.size() + 1);
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto key = [&current](std::size_t place) {
        const core::RegistrationCase* view = viewAt(current, place);
        return view ? std::tuple(view->cArm.primaryAngleDeg.value.value_or(1e3),
                                 view->cArm.secondaryAngleDeg.value.value_or(1e3), view->imageFile.path)
                    : std::tuple(1e4, 1e4, current.otherViews[place - 1].file.path);
    };
    std::ranges::stable_sort(order, {}, key);
    return order;
}

QString nameOf(const core::RegistrationCase& current, std::size_t place)
{
    const core::RegistrationCase* view = viewAt(current, place);
    const std::string& path = view ? view->imageFile.path : current.otherViews[place - 1].file.path;
    return QFileInfo(QString::fromStdString(path)).fileName();
}

QString anglesOf(const core::RegistrationCase& current, std::size_t place)
{
    const core::RegistrationCase* view = viewAt(current, place);
    if (!view || !view->cArm.primaryAngleDeg.value || !view->cArm.secondaryAngleDeg.value) {
        return nameOf(current, place);
    }
    return QString::fromStdString(primaryAngleText(*view->cArm.primaryAngleDeg.value)) + QStringLiteral(" · ") +
           QString::fromStdString(secondaryAngleText(*view->cArm.secondaryAngleDeg.value));
}

}   // namespace

ViewController::ViewController(CaseDocument& document, const TargetProvider& target, ui::MainWindow& window,
                               QObject* parent)
    : QObject(parent), document_(document), target_(target), window_(window)
{
    pause_.setSingleShot(true);
    pause_.setInterval(250ms);
    connect(&pause_, &QTimer::timeout, this, &ViewController::look);
    connect(&looking_, &QFutureWatcherBase::finished, this, &ViewController::showPictures);
    connect(&document_, &CaseDocument::changed, this, &ViewController::followDocument);
    connect(&target_, &TargetProvider::changed, this, &ViewController::followDocument);
    connect(&document_, &CaseDocument::stateChanged, this, &ViewController::followDocument);
    connectWindow();
    ui::speak(this, [this] { followDocument(); });
}

ViewController::~ViewController()
{
    waitFor(looking_);
}

void ViewController::connectWindow()
{
    const ui::WindowActions& actions = window_.actions();
    ui::ViewStrip& strip = window_.views();
    connect(&strip, &ui::ViewStrip::viewPicked, this, &ViewController::show);
    connect(&strip, &ui::ViewStrip::removeRequested, this, &ViewController::remove);
    connect(&strip, &ui::ViewStrip::addRequested, actions[ui::Command::AddView], &QAction::trigger);
    connect(&strip, &ui::ViewStrip::menuRequested, this, [this](int line, const QPoint& at) {
        auto* menu = new QMenu(&window_);
        menu->setAttribute(Qt::WA_DeleteOnClose);
        menu->addAction(tr("Show this view"), this, [this, line] { show(line); });
        menu->addAction(tr("Take this view out"), this, [this, line] { remove(line); });
        menu->popup(at);
    });
    connect(actions[ui::Command::NextView], &QAction::triggered, this, &ViewController::showNext);
}

void ViewController::followDocument()
{
    const core::RegistrationCase& current = document_.current();
    const bool areSeveral = !current.otherViews.empty() && current.angiogram;
    window_.actions()[ui::Command::NextView]->setEnabled(areSeveral && !document_.isInTrial());
    window_.actions()[ui::Command::AddView]->setEnabled(current.angiogram && current.tree && !document_.isInTrial());
    window_.views().setEnabled(!document_.isLocked() && !document_.isInTrial());
    window_.registration().showViewCount(areSeveral ? static_cast<int>(core::casesOfViews(current).size()) : 1);
    order_ = areSeveral ? lineOrder(current) : std::vector<std::size_t>{};
    showLines();
    Seen seen;
    if (areSeveral) {
        seen = {
            current.tree,       current.angiogram,         current.frame,           current.cameraFromPatient.matrix(),
            current.otherViews, current.excludedBranchIds, current.hiddenBranchIds, target_.current()};
    }
    if (seen != seen_) {
        seen_ = seen;
        if (areSeveral) {
            pause_.start();
        } else {
            looks_.clear();   // they hold the views of the case that was
        }
    }
}

const ViewLook* ViewController::lookOf(std::size_t place) const
{
    const auto& others = document_.current().otherViews;
    const auto view = place == 0 ? nullptr : others[place - 1].view;
    const auto found = std::ranges::find(looks_, view, &ViewLook::view);
    return found == looks_.end() || (place > 0 && !view) ? nullptr : &*found;
}

void ViewController::showLines()
{
    const core::RegistrationCase& current = document_.current();
    std::vector<ui::ViewLine> lines;
    int shown = 0;
    for (const std::size_t place : order_) {
        const core::RegistrationCase* view = viewAt(current, place);
        const ViewLook* look = lookOf(place);
        shown = place == 0 ? static_cast<int>(lines.size()) : shown;
        QString agreement;
        if (look && look->metrics) {
            agreement = tr("%1 mm · %2 px")
                            .arg(ui::numberText(look->metrics->medianMm, 2))
                            .arg(ui::numberText(look->metrics->medianPx, 1));
        } else {
            agreement = view && view->angiogram ? QStringLiteral("…") : tr("not found");
        }
        const QString problem = look ? ui::messageText(look->problem) : QString();
        lines.push_back({ui::withDecimalSign(anglesOf(current, place)) + QLatin1Char('\n') + agreement,
                         problem.isEmpty()
                             ? tr("%1. A click shows it, Delete takes the shown view out.").arg(nameOf(current, place))
                             : nameOf(current, place) + QStringLiteral(": ") + problem});
    }
    window_.views().showViews(lines, shown);
}

void ViewController::look()
{
    if (looking_.isRunning()) {
        pause_.start();
        return;
    }
    if (seen_.others.empty()) {
        return;
    }
    looking_.setFuture(QtConcurrent::run(
        [snapshot = document_.current(), target = target_.current(), known = looks_,
         widthPx = window_.views().pictureWidthPx()] { return lookAtViews(snapshot, target, known, widthPx); }));
}

void ViewController::showPictures()
{
    if (looking_.future().resultCount() == 0) {
        return;
    }
    std::vector<ViewLook> looks = takeResult(looking_);
    if (seen_.others.empty()) {
        return;   // of a case that was closed meanwhile
    }
    looks_ = std::move(looks);
    showLines();
    for (std::size_t line = 0; line < order_.size(); ++line) {
        const ViewLook* look = lookOf(order_[line]);
        if (look && look->picture) {
            window_.views().showPicture(static_cast<int>(line), *look->picture);
        }
    }
}

void ViewController::show(int line)
{
    const std::size_t place = order_[static_cast<std::size_t>(line)];
    if (place == 0) {
        return;
    }
    const core::RegistrationCase& current = document_.current();
    const core::RegistrationCase* view = viewAt(current, place);
    if (!view || !view->angiogram) {
        emit refused(tr("The image of this view could not be read."));
    } else {
        document_.push(showView(document_, core::showingView(current, place - 1), [name = anglesOf(current, place)] {
            return tr("Show view %1").arg(ui::withDecimalSign(name));
        }));
    }
    showLines();   // the mark goes back where it was refused
}

void ViewController::showNext()
{
    const auto shown = std::ranges::find(order_, std::size_t{0});
    if (shown != order_.end()) {
        const auto next = shown + 1 == order_.end() ? order_.begin() : shown + 1;
        show(static_cast<int>(next - order_.begin()));
    }
}

void ViewController::remove(int line)
{
    core::RegistrationCase wanted = document_.current();
    std::size_t place = order_[static_cast<std::size_t>(line)];
    if (place == 0) {
        const auto& others = wanted.otherViews;
        const auto next =
            std::ranges::find_if(others, [](const auto& other) { return other.view && other.view->angiogram; });
        if (next == others.end()) {
            emit refused(tr("No other view can be shown in its place."));
            return;
        }
        place = static_cast<std::size_t>(next - others.begin()) + 1;
        wanted = core::showingView(std::move(wanted), place - 1);
    }
    wanted.otherViews.erase(wanted.otherViews.begin() + static_cast<std::ptrdiff_t>(place - 1));
    document_.push(showView(document_, wanted, [] { return tr("Take a view out"); }));
}

}   // namespace angiopose::app