#include "app/views/linked_crosshair.h"

#include "app/preferences/settings.h"
#include "core/vessel/place_on_tree.h"
#include "ui/actions/key_hint.h"
#include "ui/actions/window_actions.h"
#include "ui/panels/view_strip.h"
#include "ui/places/side_by_side.h"
#include "ui/slices/slice_model.h"
#include "ui/views/angiogram_view.h"
#include "ui/views/tree_view.h"

namespace angiopose::app {
namespace {

constexpr double crosshairReachPx = 8.0;   // maximum distance of a vessel from the pointer, widget px

core::Sight sightIn(const ui::AngiogramView& image)
{
    return {image.camera(), image.cameraFromPatient()};
}

bool isInside(const core::ImageF& frame, const Eigen::Vector2d& px)
{
    return px.x() >= -0.5 && px.y() >= -0.5 && px.x() <= frame.width - 0.5 && px.y() <= frame.height - 0.5;
}

}   // namespace

LinkedCrosshair::LinkedCrosshair(const CaseDocument& document, const PosePreview& preview, const Ui& ui,
                                 QObject* parent)
    : QObject(parent), ui_(ui)
{
    again_.setSingleShot(true);
    again_.setInterval(0);
    connect(&again_, &QTimer::timeout, this, &LinkedCrosshair::show);
    connect(&document, &CaseDocument::changed, &again_, qOverload<>(&QTimer::start));
    connect(&preview, &PosePreview::changed, &again_, qOverload<>(&QTimer::start));
    follow(ui_.images.shown());
    connect(&ui_.images, &ui::SideBySide::paneMade, this, [this](ui::ViewPane* pane) { follow(pane->image()); });
    QAction* action = ui_.actions[ui::Command::LinkedCrosshair];
    action->setChecked(settings::linkedCrosshair.read());
    ui_.strip.showCrosshair(action->isChecked());
    connect(action, &QAction::toggled, this, &LinkedCrosshair::setOn);
    connect(&ui_.strip, &ui::ViewStrip::crosshairRequested, action, &QAction::setChecked);
}

void LinkedCrosshair::follow(ui::AngiogramView& image)
{
    connect(&image, &ui::AngiogramView::pointed, this,
            [this, &image](const std::optional<Eigen::Vector2d>& px) { point(image, px); });
    connect(&image, &ui::AngiogramView::branchClicked, this, [this] {
        if (const auto place = placeUnderPointer(); place && isLinking()) {
            ui_.slices.setCrosshair(*place);
        }
    });
}

void LinkedCrosshair::setOn(bool on)
{
    settings::linkedCrosshair.write(on);
    ui_.strip.showCrosshair(on);
    show();
    if (on && ui_.images.paneCount() == 0) {
        emit reported(tr("The crosshair links side-by-side views (%1).").arg(ui::keyOf(ui::Command::SideBySide)));
    }
}

bool LinkedCrosshair::isLinking() const
{
    return ui_.images.paneCount() > 0 && ui_.actions[ui::Command::LinkedCrosshair]->isChecked();
}

void LinkedCrosshair::point(ui::AngiogramView& image, const std::optional<Eigen::Vector2d>& imagePx)
{
    if (!imagePx && pointedIn_ != &image) {
        return;   // the pointer has already entered another view
    }
    pointedIn_ = &image;
    pointerPx_ = imagePx && isInside(image.scene().frame(), *imagePx) ? imagePx : std::nullopt;
    show();
}

std::optional<Eigen::Vector3d> LinkedCrosshair::placeUnderPointer() const
{
    if (!pointedIn_ || !pointerPx_ || core::findProblem(pointedIn_->camera()) ||
        pointedIn_->scene().mode() == ui::OverlayMode::Hidden) {
        return std::nullopt;
    }
    return core::placeUnderPixel(pointedIn_->scene().content().tree, sightIn(*pointedIn_), *pointerPx_,
                                 crosshairReachPx / pointedIn_->zoom());
}

void LinkedCrosshair::show()
{
    if (!isLinking() || !pointedIn_ || !pointerPx_) {
        hide();
        return;
    }
    const auto place = placeUnderPointer();
    for (ui::AngiogramView* image : ui_.images.images()) {
        const bool isOwn = image == pointedIn_;
        image->setCrosshair(
            {isOwn ? std::nullopt : core::epipolarLine(sightIn(*pointedIn_), *pointerPx_, sightIn(*image)), place});
    }
    ui_.treeView.setPointed(place);
}

void LinkedCrosshair::hide()
{
    for (ui::AngiogramView* image : ui_.images.images()) {
        image->setCrosshair({});
    }
    ui_.treeView.setPointed(std::nullopt);
}

}   // namespace angiopose::app
