#include "ui/plots/simulated_view.h"

#include "core/viewing/vessel_pieces.h"
#include "ui/theme/active_theme.h"
#include "ui/words/spoken.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace angiopose::ui {
namespace {

constexpr double thinnestPx = 1.2;

}   // namespace

SimulatedView::SimulatedView(QWidget* parent) : QWidget(parent)
{
    setMinimumSize(190, 190);
    withName(this, [] { return tr("The vessels from these angles"); });
}

void SimulatedView::showVessels(std::shared_ptr<const core::VesselTree> tree, int branchId,
                                const std::optional<core::Sight>& sight)
{
    tree_ = std::move(tree);
    branchId_ = branchId;
    sight_ = sight;
    update();
}

void SimulatedView::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), toQColor(activePalette().canvas));
    if (!tree_ || !sight_) {
        return;
    }
    const core::ProjectionCamera& camera = sight_->camera;
    const double scale =
        std::min(static_cast<double>(width()) / camera.width, static_cast<double>(height()) / camera.height);
    painter.translate((width() - scale * camera.width) / 2.0, (height() - scale * camera.height) / 2.0);
    painter.setClipRect(QRectF(0.0, 0.0, scale * camera.width, scale * camera.height));
    painter.fillRect(QRectF(0.0, 0.0, scale * camera.width, scale * camera.height),
                     toQColor(ui::palette(ThemeMode::Dark).line));
    for (const core::VesselBranch& branch : tree_->branches) {
        if (branch.id != branchId_) {
            paintBranch(painter, branch, scale);
        }
    }
    if (const core::VesselBranch* chosen = tree_->find(branchId_)) {
        paintBranch(painter, *chosen, scale);
    }
}

void SimulatedView::paintBranch(QPainter& painter, const core::VesselBranch& branch, double scale) const
{
    const Palette& tones = ui::palette(ThemeMode::Dark);   // the ground is dark in every theme
    QPen pen(toQColor(branch.id == branchId_ ? tones.accent : tones.label));
    pen.setCapStyle(Qt::RoundCap);
    std::optional<Eigen::Vector2d> before;
    for (std::size_t i = 0; i < branch.pointsInPatient.size(); ++i) {
        const Eigen::Vector3d inCamera = sight_->cameraFromPatient * branch.pointsInPatient[i];
        const auto pixel = core::project(sight_->camera, inCamera);
        if (pixel && before) {
            const double radiusMm = branch.radiusMm.empty() ? core::assumedRadiusMm : branch.radiusMm[i];
            const double widthPx = 2.0 * radiusMm * std::abs(sight_->camera.fy) / inCamera.z();
            pen.setWidthF(std::max(thinnestPx, scale * widthPx));
            painter.setPen(pen);
            painter.drawLine(QPointF(before->x(), before->y()) * scale, QPointF(pixel->x(), pixel->y()) * scale);
        }
        before = pixel;
    }
}

}   // namespace angiopose::ui
