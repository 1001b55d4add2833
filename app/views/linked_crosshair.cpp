#include "app/views/linked_crosshair.h"

#include "app/preferences/settings.h"
#include "core/vessel/tree_position.h"
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

core::PosedCamera posedCameraOf(const ui::AngiogramView& image)
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
    updateTimer_.setSingleShot(true);
    updateTimer_.setInterval(0);
    connect(&updateTimer_, &QTimer::timeout, this, &LinkedCrosshair::show);
    connect(&document, &CaseDocument::changed, &updateTimer_, qOverload<>(&QTimer::start));
    connect(&preview, &PosePreview::changed, &updateTimer_, qOverload<>(&QTimer::start));
    follow(ui_.images.shown());
    connect(&ui_.images, &ui::SideBySide::paneCreated, this, [this](ui::ViewPane* pane) { follow(pane->image()); });
    QAction* action = ui_.actions[ui::Command::LinkedCrosshair];
    action->setChecked(settings::linkedCrosshair.read());
    ui_.strip.showCrosshair(action->isChecked());
    connect(action, &QAction::toggled, this, &LinkedCrosshair::setOn);
    connect(&ui_.strip, &ui::ViewStrip::crosshairRequested, action, &QAction::setChecked);
}

void LinkedCrosshair::follow(ui::AngiogramView& image)
{
    connect(&image, &ui::AngiogramView::pointerMoved, this,
            [this, &image](const std::optional<Eigen::Vector2d>& px) { point(image, px); });
    connect(&image, &ui::AngiogramView::branchClicked, this, [this] {
        if (const auto place = pointUnderPointer(); place && isLinking()) {
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
        emit reported(
            tr("The crosshair is linked across side-by-side views (%1).").arg(ui::keyOf(ui::Command::SideBySide)));
    }
}

bool LinkedCrosshair::isLinking() const
{
    return ui_.images.paneCount() > 0 && ui_.actions[ui::Command::LinkedCrosshair]->isChecked();
}

void LinkedCrosshair::point(ui::AngiogramView& image, const std::optional<Eigen::Vector2d>& imagePx)
{
    if (!imagePx && pointerView_ != &image) {
        return;   // the pointer has already entered another view
    }
    pointerView_ = &image;
    pointerPx_ = imagePx && isInside(image.scene().frame(), *imagePx) ? imagePx : std::nullopt;
    show();
}

std::optional<Eigen::Vector3d> LinkedCrosshair::pointUnderPointer() const
{
    if (!pointerView_ || !pointerPx_ || core::findProblem(pointerView_->camera()) ||
        pointerView_->scene().mode() == ui::OverlayMode::Hidden) {
        return std::nullopt;
    }
    return core::pointUnderPixel(pointerView_->scene().content().tree, posedCameraOf(*pointerView_), *pointerPx_,
                                 crosshairReachPx / pointerView_->zoom());
}

void LinkedCrosshair::show()
{
    if (!isLinking() || !pointerView_ || !pointerPx_) {
        hide();
        return;
    }
    const auto place = pointUnderPointer();
    for (ui::AngiogramView* image : ui_.images.images()) {
        const bool isOwn = image == pointerView_;
        image->setCrosshair({isOwn
                                 ? std::nullopt
                                 : core::epipolarLine(posedCameraOf(*pointerView_), *pointerPx_, posedCameraOf(*image)),
                             place});
    }
    ui_.treeView.setPointedPosition(place);
}

void LinkedCrosshair::hide()
{
    for (ui::AngiogramView* image : ui_.images.images()) {
        image->setCrosshair({});
    }
    ui_.treeView.setPointedPosition(std::nullopt);
}

}   // namespace angiopose::app
