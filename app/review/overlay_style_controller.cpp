#include "app/review/overlay_style_controller.h"

#include "app/preferences/settings.h"
#include "ui/actions/window_actions.h"
#include "ui/panels/angiogram_panel.h"
#include "ui/panels/bottom_strip.h"
#include "ui/views/angiogram_view.h"
#include "ui/words/number.h"

#include <QApplication>

#include <algorithm>

namespace angiopose::app {
namespace {

constexpr double opacityStep = 0.1;

}   // namespace

OverlayStyleController::OverlayStyleController(const CaseDocument& document, ViewSync& sync, const Ui& ui,
                                               QObject* parent)
    : QObject(parent), document_(document), sync_(sync), ui_(ui), brightness_(document, ui.view)
{
    connectOverlay();
    connectBrightness();
}

void OverlayStyleController::connectOverlay()
{
    ui::WindowActions& actions = ui_.actions;
    ui::AngiogramView& view = ui_.view;
    connect(actions[ui::Command::Fit], &QAction::triggered, this, [this] { image().fitToWindow(); });
    connect(actions[ui::Command::Outline], &QAction::triggered, this, &OverlayStyleController::cycleStyle);
    connect(actions[ui::Command::Swipe], &QAction::triggered, this, &OverlayStyleController::cycleCutout);
    connect(actions[ui::Command::WorstBranch], &QAction::triggered, this, &OverlayStyleController::showNextWorst);
    connect(actions[ui::Command::MirrorView], &QAction::toggled, this, [this, &view](bool on) {
        view.setFromSource(on);
        emit changed();
        ui_.strip.showStatus(on ? tr("View from the source: only the display is mirrored")
                                : tr("View from the detector"));
    });
    connect(actions[ui::Command::DepthCue], &QAction::toggled, this, [this, &view](bool on) {
        view.scene().setDepthCue(on ? ui::DepthCue::NearBright : ui::DepthCue::None);
        redraw();
        ui_.strip.showStatus(on ? tr("Depth cueing") : tr("Depth cueing off"));
    });
    connect(actions[ui::Command::ShowTrace], &QAction::toggled, this, [this, &view](bool on) {
        view.scene().showTracedCenterline(on);
        redraw();
    });
    connect(actions[ui::Command::MoreOpacity], &QAction::triggered, this, [this] { changeOpacity(opacityStep); });
    connect(actions[ui::Command::LessOpacity], &QAction::triggered, this, [this] { changeOpacity(-opacityStep); });
    view.scene().setOpacity(settings::overlayOpacity.read());

    QAction* identity = actions[ui::Command::HideIdentity];
    connect(identity, &QAction::toggled, this, [this](bool hidden) {
        settings::identityHidden.write(hidden);
        sync_.setIdentityHidden(hidden);
    });
    identity->setChecked(settings::identityHidden.read());
}

void OverlayStyleController::connectBrightness()
{
    ui::WindowActions& actions = ui_.actions;
    ui::AngiogramView& view = ui_.view;
    ui::AngiogramPanel& panel = ui_.panel;
    connect(&view, &ui::AngiogramView::windowLevelChanged, &panel, &ui::AngiogramPanel::showWindowLevel);
    connect(&panel, &ui::AngiogramPanel::windowLevelTyped, &view, &ui::AngiogramView::setWindowLevel);
    connect(actions[ui::Command::AutoWindow], &QAction::triggered, this, [this] { image().autoWindowLevel(); });
    connect(actions[ui::Command::VesselWindow], &QAction::triggered, this, [this] {
        const auto& angiogram = document_.current().shown().angiogram;
        const core::Polarity polarity = angiogram ? angiogram->polarity : core::Polarity::VesselsDark;
        showRange(core::vesselRange(image().scene().frame(), polarity));
    });
    connect(actions[ui::Command::SoftWindow], &QAction::triggered, this, [this] {
        constexpr double soft = 1.8;
        image().autoWindowLevel();
        scaleWindow(soft);
    });
    connect(actions[ui::Command::FullRange], &QAction::triggered, this, &OverlayStyleController::showFullRange);
    connect(actions[ui::Command::MoreContrast], &QAction::triggered, this, [this] { scaleWindow(0.5); });
    connect(actions[ui::Command::LessContrast], &QAction::triggered, this, [this] { scaleWindow(2.0); });
    connect(actions[ui::Command::Invert], &QAction::toggled, this, [this, &view](bool on) {
        view.scene().setInverted(on);
        redraw();
    });
}

ui::AngiogramView& OverlayStyleController::image() const
{
    auto* focused = qobject_cast<ui::AngiogramView*>(QApplication::focusWidget());
    return focused ? *focused : ui_.view;
}

void OverlayStyleController::redraw()
{
    ui_.view.redraw();
    emit changed();
}

void OverlayStyleController::setHiddenWhileHeld(bool held)
{
    isHiddenWhileHeld_ = held;
    showStyle();
}

void OverlayStyleController::showStyle()
{
    ui_.view.scene().setMode(isHiddenWhileHeld_ || isDrr_ ? ui::OverlayMode::Hidden : style_);
    redraw();
    emit drrRequested(isDrr_ && !isHiddenWhileHeld_);
}

bool OverlayStyleController::hasRadii() const
{
    const auto& tree = document_.current().vessels.tree;
    return tree && std::ranges::any_of(tree->branches, [](const core::VesselBranch& branch) {
               return std::ranges::any_of(branch.radiusMm, [](double radius) { return radius > 0.0; });
           });
}

QString OverlayStyleController::drrStyleName() const
{
    return document_.current().vessels.scan ? tr("Vessels as DRR of the scan") : tr("Vessels as DRR of the tube model");
}

void OverlayStyleController::cycleStyle()
{
    using enum ui::OverlayMode;
    const bool isLast = style_ == Tube || !hasRadii();   // outlines and tubes require radii
    style_ = isDrr_ || isLast ? Centerline : style_ == Centerline ? Outline : Tube;
    isDrr_ = !isDrr_ && isLast;
    ui_.strip.showStatus(isDrr_                 ? drrStyleName()
                         : style_ == Centerline ? tr("Vessels as centerlines")
                         : style_ == Outline    ? tr("Vessels as outlines")
                                                : tr("Vessels as tubes"));
    showStyle();
}

void OverlayStyleController::cycleCutout()
{
    using enum ui::Cutout::Shape;
    ui::AngiogramView& view = ui_.view;
    view.setCutout(view.cutout() == None ? RightOf : view.cutout() == RightOf ? Disc : None);
    ui_.strip.showStatus(view.cutout() == RightOf ? tr("Swipe: the overlay ends at the mouse pointer")
                         : view.cutout() == Disc  ? tr("Lens: hides the overlay around the mouse pointer")
                                                  : tr("Swipe and lens off"));
}

void OverlayStyleController::changeOpacity(double by)
{
    const double opacity = std::clamp(settings::overlayOpacity.read() + by, opacityStep, 1.0);
    settings::overlayOpacity.write(opacity);
    ui_.view.scene().setOpacity(opacity);
    redraw();
    ui_.strip.showStatus(tr("Overlay opacity %1 %").arg(ui::numberText(100.0 * opacity, 0)));
}

void OverlayStyleController::scaleWindow(double factor)
{
    ui::AngiogramView& view = image();
    const core::DisplayRange shown = view.shownRange();
    view.setWindowLevel(factor * shown.window(), shown.level());
}

void OverlayStyleController::showRange(const core::DisplayRange& range)
{
    image().setWindowLevel(range.window(), range.level());
}

void OverlayStyleController::showFullRange()
{
    ui::AngiogramView& view = image();
    const std::vector<float>& pixels = view.scene().frame().pixels;
    if (!pixels.empty()) {
        const auto [low, high] = std::ranges::minmax(pixels);
        view.setWindowLevel(std::max(1e-6, static_cast<double>(high) - low), 0.5 * (static_cast<double>(high) + low));
    }
}

void OverlayStyleController::setResiduals(std::vector<core::BranchResidual> branches, double millimetersPerPixel)
{
    std::ranges::stable_sort(branches, std::greater{}, &core::BranchResidual::medianPx);
    residuals_ = std::move(branches);
    millimetersPerPixel_ = millimetersPerPixel;
    nextResidual_ = 0;
}

void OverlayStyleController::showNextWorst()
{
    if (residuals_.empty()) {
        ui_.strip.showStatus(tr("No residuals yet"));
        return;
    }
    const std::size_t rank = nextResidual_ % residuals_.size();
    const core::BranchResidual& branch = residuals_[rank];
    nextResidual_ = rank + 1;
    if (const auto extent = ui_.view.scene().extentOf(branch.branchId)) {
        ui_.view.zoomTo(*extent);
    }
    emit branchRequested(branch.branchId);
    ui_.strip.showStatus(tr("Worst %1 of %2: median %3 mm · W next · 1 fit view")
                             .arg(rank + 1)
                             .arg(residuals_.size())
                             .arg(ui::numberText(branch.medianPx * millimetersPerPixel_, 2)));
}

}   // namespace angiopose::app
