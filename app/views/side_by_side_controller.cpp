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
#include "ui/words/retranslation.h"

#include <QDateTime>

#include <algorithm>
#include <utility>

namespace angiopose::app {
namespace {

constexpr int framesOfOthers =
    1 << 21;   ///< offset that separates the merge IDs from those of poses and of frames of the shown view
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
    : QObject(parent), parts_(parts), ui_(ui)
{
    connect(&ui_.images, &ui::SideBySide::paneCreated, this, &SideBySideController::connectPane);
    QAction* action = ui_.actions[ui::Command::SideBySide];
    action->setChecked(settings::sideBySide.read());
    ui_.strip.showSideBySide(action->isChecked());
    connect(action, &QAction::toggled, this, &SideBySideController::setOn);
    connect(&ui_.strip, &ui::ViewStrip::sideBySideRequested, action, &QAction::setChecked);
    connectCase();
    connectOverlayStyle();
    ui::keepTranslated(this, [this] { showTitles(); });
}

void SideBySideController::connectCase()
{
    connect(&parts_.document, &CaseDocument::changed, this, &SideBySideController::show);
    connect(&parts_.document, &CaseDocument::stateChanged, this, &SideBySideController::show);
    connect(&parts_.preview, &PosePreview::changed, this, [this] {
        for (SecondaryViewController* other : shown()) {
            other->showPose();
        }
        if (std::exchange(areLinked_, parts_.preview.movesAllViews()) != areLinked_) {
            showTitles();
        }
    });
    connect(&parts_.views, &ViewController::summariesReady, this, [this] {
        for (SecondaryViewController* other : shown()) {
            other->showColors();
        }
    });
}

/// Connects the display settings of the shown view, so that changes also apply to the other views.
void SideBySideController::connectOverlayStyle()
{
    using enum ui::Command;
    connect(&parts_.overlayStyle, &OverlayStyleController::changed, this,
            &SideBySideController::applyDisplaySettingsToAll);
    connect(&parts_.branches, &BranchController::marksChanged, this, &SideBySideController::applyDisplaySettingsToAll);
    for (const ui::Command mouse :
         {MouseRadiology, MouseSlicer, MouseScroll}) {   // queued until the choice has taken effect
        connect(ui_.actions[mouse], &QAction::triggered, this, &SideBySideController::applyDisplaySettingsToAll,
                Qt::QueuedConnection);
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
    const SecondaryViewController::Parts parts{parts_.document,     parts_.preview,     parts_.views,
                                               parts_.overlayStyle, ui_.images.shown(), *pane};
    const SecondaryViewController& other = *others_.emplace_back(std::make_unique<SecondaryViewController>(parts));
    connect(pane, &ui::ViewPane::viewChosen, this, [this, &other, pane] { choose(other.viewIndex(), pane->image()); });
    connect(pane, &ui::ViewPane::frameRequested, this, [this, &other](int frame) { changeFrame(other, frame); });
    connect(pane, &ui::ViewPane::menuRequested, this,
            [this, &other](const QPoint& at) { parts_.views.openMenu(static_cast<int>(other.viewIndex()), at); });
    const ui::AngiogramView& image = pane->image();
    connect(&image, &ui::AngiogramView::branchHovered, &parts_.branches, &BranchController::hover);
    connect(&image, &ui::AngiogramView::branchClicked, &parts_.branches, &BranchController::click);
    connect(&image, &ui::AngiogramView::backgroundClicked, this, [this] { parts_.branches.select({}); });
}

/// Swaps the selected view with the shown one; each keeps its zoom.
void SideBySideController::choose(std::size_t viewIndex, ui::AngiogramView& image)
{
    ui::AngiogramView& shown = ui_.images.shown();
    const Zoom ofChosen(image);
    const Zoom ofFormer(shown);
    parts_.views.show(static_cast<int>(viewIndex));
    if (parts_.document.current().shownView == viewIndex) {
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
        emit reported(emptyReason());
    }
}

std::vector<std::size_t> SideBySideController::others() const
{
    const core::Case& current = parts_.document.current();
    std::vector<std::size_t> places;
    if (!parts_.document.isInTrial() &&
        current.shown().angiogram) {   // hidden during a blind trial, because they would reveal the answer
        for (std::size_t viewIndex = 0; viewIndex < current.views.size(); ++viewIndex) {
            if (viewIndex != current.shownView) {
                places.push_back(viewIndex);
            }
        }
    }
    return places;
}

QString SideBySideController::emptyReason() const
{
    return parts_.document.isInTrial()
               ? tr("Other views are hidden during a blind trial because they would reveal the true pose.")
           : !parts_.document.current().shown().angiogram
               ? tr("Open an angiogram first. Another view can then be shown next to it.")
               : tr("This case has only one view. Add another angiogram of the same vessels (%1) to show both side by "
                    "side.")
                     .arg(ui::keyOf(ui::Command::AddView));
}

/// Returns the index of the view in each pane. A view keeps its pane as long as it exists, so that a selected view
/// swaps places with the shown one.
std::vector<std::size_t> SideBySideController::paneViewIndices() const
{
    std::vector<std::size_t> viewIndices = others();
    if (viewIndices.size() != ui_.images.paneCount()) {
        return viewIndices;
    }
    std::vector<std::size_t> left = viewIndices;
    for (std::size_t i = 0; i < viewIndices.size(); ++i) {
        std::erase(left, others_[i]->viewIndex());
    }
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < viewIndices.size(); ++i) {
        const std::size_t own = others_[i]->viewIndex();
        const bool stays = std::ranges::find(viewIndices, own) != viewIndices.end();
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
    const std::vector<std::size_t> places = isOn ? paneViewIndices() : std::vector<std::size_t>{};
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
        applyDisplaySettingsToAll();
    }
    showTitles();
}

void SideBySideController::showTitles()
{
    const core::Case& current = parts_.document.current();
    ui_.images.title().showTexts(numberedTitle(current.views, current.shownView), {}, fileNameOf(current.shown()));
    for (std::size_t i = 0; i < ui_.images.paneCount(); ++i) {
        const std::size_t viewIndex = others_[i]->viewIndex();
        const core::View& view = current.views[viewIndex];
        ui::ViewPane& pane = ui_.images.pane(i);
        const auto camera = core::cameraOf(view);
        const QString title = numberedTitle(current.views, viewIndex);
        const bool goesAlong = areLinked_;
        const QString note = !camera ? tr("no geometry") : goesAlong ? tr("linked") : tr("independent pose");
        const QString why = !camera     ? ui::messageText(camera.error().message)
                            : goesAlong ? tr("The vessels in this view move together with those in the active view.")
                                        : tr("The views are not registered jointly: moving the vessels in the active "
                                             "view does not move them in this view.");
        pane.title().showTexts(title, view.angiogram ? note : QString(),
                               fileNameOf(view) + QLatin1Char('\n') +
                                   (view.angiogram ? why + QLatin1Char('\n') : QString()) +
                                   tr("Click here, or double-click the image, to make this the active view."));
        pane.image().setPlaceholderText(tr("The image of this view could not be read."));
        pane.image().setAccessibleName(title);
    }
}

std::vector<SecondaryViewController*> SideBySideController::shown() const
{
    std::vector<SecondaryViewController*> shown;
    for (std::size_t i = 0; i < ui_.images.paneCount(); ++i) {
        if (others_[i]->viewIndex() < parts_.document.current().views.size()) {   // otherwise, the view was removed
            shown.push_back(others_[i].get());
        }
    }
    return shown;
}

void SideBySideController::applyDisplaySettingsToAll()
{
    for (SecondaryViewController* other : shown()) {
        other->applyDisplaySettings();
    }
}

/// Sets the frame of a view in the case, even if it is not the shown view, because pose, target and result depend on
/// the frame.
void SideBySideController::changeFrame(const SecondaryViewController& other, int frame)
{
    const core::Case& current = parts_.document.current();
    const std::size_t viewIndex = other.viewIndex();
    if (frame == current.views[viewIndex].frame) {
        return;
    }
    const qint64 now = QDateTime::currentMSecsSinceEpoch();
    if (now - lastFrameChangeMs_ > frameBurstPauseMs || viewIndex != mergedViewIndex_) {
        ++frameMergeId_;
    }
    lastFrameChangeMs_ = now;
    mergedViewIndex_ = viewIndex;
    std::vector<core::View> views = current.views;
    views[viewIndex] = core::withFrame(std::move(views[viewIndex]), frame);
    views[viewIndex].caseFile = {};   // its case file no longer contains the view unchanged
    parts_.document.push(std::make_unique<ChangeViews>(
        parts_.document, ChangeViews::Values{std::move(views)}, [] { return tr("Choose another frame"); },
        framesOfOthers + frameMergeId_));
}

}   // namespace angiopose::app
