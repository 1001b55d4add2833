#include "app/views/side_by_side_controller.h"

#include "app/document/edit_case.h"
#include "app/editing/branch_controller.h"
#include "app/preferences/settings.h"
#include "app/words/view_words.h"
#include "ui/actions/key_hint.h"
#include "ui/actions/window_actions.h"
#include "ui/panels/view_strip.h"
#include "ui/places/side_by_side.h"
#include "ui/views/angiogram_view.h"
#include "ui/words/message_text.h"
#include "ui/words/spoken.h"

#include <QDateTime>

#include <algorithm>
#include <utility>

namespace angiopose::app {
namespace {

constexpr int framesOfOthers =
    1 << 21;   ///< offset that separates the undo-merge ids from those of poses and of the shown view's frames
constexpr qint64 frameBurstPauseMs = 1500;

/// Zoom and pan of a view.
class Zoom {
public:
    explicit Zoom(const ui::AngiogramView& view) : isFitted_(view.isFitted()), part_(view.visiblePart()) {}
    void applyTo(ui::AngiogramView& view) const
    {
        if (isFitted_) {
            view.fitToWindow();
        } else {
            view.showPart(part_);
        }
    }

private:
    bool isFitted_;
    ui::ViewRect part_;
};

}   // namespace

SideBySideController::SideBySideController(const Parts& parts, const Ui& ui, QObject* parent)
    : QObject(parent), on_(parts), ui_(ui)
{
    connect(&ui_.images, &ui::SideBySide::paneMade, this, &SideBySideController::connectPane);
    QAction* action = ui_.actions[ui::Command::SideBySide];
    action->setChecked(settings::sideBySide.read());
    ui_.strip.showSideBySide(action->isChecked());
    connect(action, &QAction::toggled, this, &SideBySideController::setOn);
    connect(&ui_.strip, &ui::ViewStrip::sideBySideRequested, action, &QAction::setChecked);
    connectCase();
    connectLook();
    ui::speak(this, [this] { showTitles(); });
}

void SideBySideController::connectCase()
{
    connect(&on_.document, &CaseDocument::changed, this, &SideBySideController::show);
    connect(&on_.document, &CaseDocument::stateChanged, this, &SideBySideController::show);
    connect(&on_.preview, &PosePreview::changed, this, [this] {
        for (OtherView* other : shown()) {
            other->showPose();
        }
        if (std::exchange(goAlong_, on_.preview.movesAllViews()) != goAlong_) {
            showTitles();
        }
    });
    connect(&on_.views, &ViewController::looked, this, [this] {
        for (OtherView* other : shown()) {
            other->showColors();
        }
    });
}

/// Connects the display settings of the shown view, so that changes also apply to the other views.
void SideBySideController::connectLook()
{
    using enum ui::Command;
    connect(&on_.look, &LookController::changed, this, &SideBySideController::takeLooks);
    connect(&on_.branches, &BranchController::marksChanged, this, &SideBySideController::takeLooks);
    for (const ui::Command mouse :
         {MouseRadiology, MouseSlicer, MouseScroll}) {   // queued: after the choice has taken effect
        connect(ui_.actions[mouse], &QAction::triggered, this, &SideBySideController::takeLooks, Qt::QueuedConnection);
    }
    for (const ui::Command colors : {ColorsBlueAmber, ColorsBlueRed, ColorsBrightness}) {
        connect(
            ui_.actions[colors], &QAction::triggered, this,
            [this] {
                for (ui::AngiogramView* image : ui_.images.images()) {
                    image->scene().recolor();
                    image->redraw();
                }
            },
            Qt::QueuedConnection);
    }
}

void SideBySideController::connectPane(ui::ViewPane* pane)
{
    const OtherView::Parts parts{on_.document, on_.preview, on_.views, on_.look, ui_.images.shown(), *pane};
    const OtherView& other = *others_.emplace_back(std::make_unique<OtherView>(parts));
    connect(pane, &ui::ViewPane::chosen, this, [this, &other, pane] { choose(other.place(), pane->image()); });
    connect(pane, &ui::ViewPane::frameRequested, this, [this, &other](int frame) { changeFrame(other, frame); });
    connect(pane, &ui::ViewPane::menuRequested, this,
            [this, &other](const QPoint& at) { on_.views.openMenu(static_cast<int>(other.place()), at); });
    const ui::AngiogramView& image = pane->image();
    connect(&image, &ui::AngiogramView::branchHovered, &on_.branches, &BranchController::hover);
    connect(&image, &ui::AngiogramView::branchClicked, &on_.branches, &BranchController::click);
    connect(&image, &ui::AngiogramView::backgroundClicked, this, [this] { on_.branches.select({}); });
}

/// Swaps the selected view with the shown one; each keeps its zoom.
void SideBySideController::choose(std::size_t place, ui::AngiogramView& image)
{
    ui::AngiogramView& shown = ui_.images.shown();
    const Zoom ofChosen(image);
    const Zoom ofFormer(shown);
    on_.views.show(static_cast<int>(place));
    if (on_.document.current().shownView == place) {
        ofChosen.applyTo(shown);
        ofFormer.applyTo(image);
        shown.setFocus(Qt::OtherFocusReason);
    }
}

void SideBySideController::setOn(bool on)
{
    settings::sideBySide.write(on);
    ui_.strip.showSideBySide(on);
    show();
    if (on && others().empty()) {
        emit reported(whyEmpty());
    }
}

std::vector<std::size_t> SideBySideController::others() const
{
    const core::Case& current = on_.document.current();
    std::vector<std::size_t> places;
    if (!on_.document.isInTrial() &&
        current.shown().angiogram) {   // hidden during a blind trial, because they would reveal the answer
        for (std::size_t place = 0; place < current.views.size(); ++place) {
            if (place != current.shownView) {
                places.push_back(place);
            }
        }
    }
    return places;
}

QString SideBySideController::whyEmpty() const
{
    return on_.document.isInTrial() ? tr("Other views are hidden during a blind trial: they would reveal the answer.")
           : !on_.document.current().shown().angiogram
               ? tr("Open an angiogram first. Another view can then be shown beside it.")
               : tr("This case has only one view. Add another angiogram of the same vessels (%1) to show both side by "
                    "side.")
                     .arg(ui::keyOf(ui::Command::AddView));
}

/// Returns the index of the view in each pane. A view keeps its pane as long as it exists, so that a selected view
/// swaps places with the shown one.
std::vector<std::size_t> SideBySideController::placesOfPanes() const
{
    std::vector<std::size_t> wanted = others();
    if (wanted.size() != ui_.images.paneCount()) {
        return wanted;
    }
    std::vector<std::size_t> left = wanted;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        std::erase(left, others_[i]->place());
    }
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const std::size_t own = others_[i]->place();
        const bool stays = std::ranges::find(wanted, own) != wanted.end();
        places.push_back(stays ? own : left.front());
        if (!stays) {
            left.erase(left.begin());
        }
    }
    return places;
}

void SideBySideController::show()
{
    const bool isOn = ui_.actions[ui::Command::SideBySide]->isChecked();
    const std::vector<std::size_t> places = isOn ? placesOfPanes() : std::vector<std::size_t>{};
    const std::size_t before = ui_.images.paneCount();
    ui_.images.setPaneCount(places.size());
    for (std::size_t i = 0; i < others_.size(); ++i) {
        if (i < places.size()) {
            others_[i]->show(places[i]);
        } else if (i < before) {
            others_[i]->clear();
        }
    }
    if (places.size() > before) {
        takeLooks();
    }
    showTitles();
}

void SideBySideController::showTitles()
{
    const core::Case& current = on_.document.current();
    ui_.images.title().showWords(numberedTitle(current.views, current.shownView), {}, fileNameOf(current.shown()));
    for (std::size_t i = 0; i < ui_.images.paneCount(); ++i) {
        const std::size_t place = others_[i]->place();
        const core::View& view = current.views[place];
        ui::ViewPane& pane = ui_.images.pane(i);
        const auto camera = core::cameraOf(view);
        const QString title = numberedTitle(current.views, place);
        const bool goesAlong = goAlong_;
        const QString note = !camera ? tr("no geometry") : goesAlong ? tr("linked") : tr("independent pose");
        const QString why = !camera     ? ui::messageText(camera.error().message)
                            : goesAlong ? tr("The vessels move here together with the active view.")
                                        : tr("The views are not registered jointly: moving the vessels in the active "
                                             "view does not move them here.");
        pane.title().showWords(title, view.angiogram ? note : QString(),
                               fileNameOf(view) + QLatin1Char('\n') +
                                   (view.angiogram ? why + QLatin1Char('\n') : QString()) +
                                   tr("Click here, or double-click the image, to make this the active view."));
        pane.image().setAbsence(tr("The image of this view could not be read."));
        pane.image().setAccessibleName(title);
    }
}

std::vector<OtherView*> SideBySideController::shown() const
{
    std::vector<OtherView*> shown;
    for (std::size_t i = 0; i < ui_.images.paneCount(); ++i) {
        if (others_[i]->place() < on_.document.current().views.size()) {   // otherwise the view was just removed
            shown.push_back(others_[i].get());
        }
    }
    return shown;
}

void SideBySideController::takeLooks()
{
    for (OtherView* other : shown()) {
        other->takeLook();
    }
}

/// Sets the frame of a view in the case, even if the view is not the shown one, because its pose, target and result
/// depend on the frame.
void SideBySideController::changeFrame(const OtherView& other, int frame)
{
    const core::Case& current = on_.document.current();
    const std::size_t place = other.place();
    if (frame == current.views[place].frame) {
        return;
    }
    const qint64 now = QDateTime::currentMSecsSinceEpoch();
    if (now - lastFrameMs_ > frameBurstPauseMs || place != burstPlace_) {
        ++frameBurst_;
    }
    lastFrameMs_ = now;
    burstPlace_ = place;
    std::vector<core::View> views = current.views;
    views[place] = core::withFrame(std::move(views[place]), frame);
    views[place].caseFile = {};   // its case file no longer contains the view unchanged
    on_.document.push(std::make_unique<ChangeViews>(
        on_.document, ChangeViews::Values{std::move(views)}, [] { return tr("Choose another frame"); },
        framesOfOthers + frameBurst_));
}

}   // namespace angiopose::app
