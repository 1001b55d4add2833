#include "ui/dialogs/angle_dialog.h"

#include "core/viewing/view_evaluator.h"
#include "ui/controls/number_field.h"
#include "ui/controls/section.h"
#include "ui/plots/angle_map_plot.h"
#include "ui/theme/active_theme.h"
#include "ui/words/number.h"
#include "ui/words/retranslation.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QPainter>
#include <QPushButton>
#include <algorithm>
#include <cmath>

namespace angiopose::ui {
namespace {

constexpr double minWidthPx = 1.2;

/// Formats gantry angles, e.g. "LAO 30° · CRA 10°".
QString angleText(const core::GantryAngles& angles)
{
    const auto text = [](double deg, const char* negative, const char* positive) {
        return QStringLiteral("%1 %2°").arg(QLatin1String(deg < 0.0 ? negative : positive),
                                            numberText(std::abs(deg), 0));
    };
    return text(angles.primaryDeg, "RAO", "LAO") + QStringLiteral(" · ") + text(angles.secondaryDeg, "CAU", "CRA");
}

QPushButton* anglesButton()
{
    auto* button = new QPushButton;
    button->setAutoDefault(false);
    return button;
}

}   // namespace

SimulatedView::SimulatedView(QWidget* parent) : QWidget(parent)
{
    setMinimumSize(190, 190);
    withAccessibleName(this, [] { return tr("Simulated view at these angles"); });
}

void SimulatedView::showVessels(std::shared_ptr<const core::VesselTree> tree, int branchId,
                                const std::optional<core::PosedCamera>& sight)
{
    tree_ = std::move(tree);
    branchId_ = branchId;
    posedCamera_ = sight;
    update();
}

void SimulatedView::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), toQColor(activePalette().canvas));
    if (!tree_ || !posedCamera_) {
        return;
    }
    const core::ProjectionCamera& camera = posedCamera_->camera;
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
    const Palette& colors = ui::palette(ThemeMode::Dark);   // the background of the view is dark in every theme
    QPen pen(toQColor(branch.id == branchId_ ? colors.accent : colors.label));
    pen.setCapStyle(Qt::RoundCap);
    std::optional<Eigen::Vector2d> before;
    for (std::size_t i = 0; i < branch.pointsInPatient.size(); ++i) {
        const Eigen::Vector3d inCamera = posedCamera_->cameraFromPatient * branch.pointsInPatient[i];
        const auto pixel = core::project(posedCamera_->camera, inCamera);
        if (pixel && before) {
            const double radiusMm = branch.radiusMm.empty() ? core::assumedRadiusMm : branch.radiusMm[i];
            const double widthPx = 2.0 * radiusMm * std::abs(posedCamera_->camera.fy) / inCamera.z();
            pen.setWidthF(std::max(minWidthPx, scale * widthPx));
            painter.setPen(pen);
            painter.drawLine(QPointF(before->x(), before->y()) * scale, QPointF(pixel->x(), pixel->y()) * scale);
        }
        before = pixel;
    }
}

AngleDialog::AngleDialog(const GantryLimits& limits, QWidget* parent)
    : QDialog(parent),
      title_(roleLabel("heading")),
      hint_(roleLabel("hint")),
      originOnly_(new QCheckBox(tr("Origin only (±10 mm)"))),
      plot_(new AngleMapPlot),
      view_(new SimulatedView),
      picked_(roleLabel("body")),
      currentButton_(anglesButton())
{
    setObjectName(QStringLiteral("angleDialog"));
    setWindowTitle(tr("C-arm angles"));
    setAttribute(Qt::WA_DeleteOnClose);
    hint_->setWordWrap(true);
    picked_->setMinimumHeight(picked_->sizeHint().height());
    auto* pictures = new QHBoxLayout;
    pictures->setSpacing(14);
    pictures->addWidget(plot_, 3);
    pictures->addWidget(view_, 2);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(20, 16, 20, 14);
    layout->setSpacing(12);
    layout->addWidget(title_);
    layout->addWidget(hint_);
    layout->addWidget(originOnly_);
    layout->addLayout(pictures, 1);
    layout->addWidget(
        roleLabel("hint", tr("Blue: visible at full length and without overlap. Amber: foreshortened or overlapped.")));
    layout->addWidget(picked_);
    layout->addLayout(makeBestButtons());
    layout->addLayout(makeLimitFields(limits));
    resize(760, 1);
    connect(originOnly_, &QCheckBox::toggled, this, &AngleDialog::criteriaChanged);
    connect(plot_, &AngleMapPlot::picked, this, &AngleDialog::picked);
    showMap({}, {});
}

QLayout* AngleDialog::makeBestButtons()
{
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    row->addWidget(currentButton_);
    currentButton_->setToolTip(tr("Gantry position of this image."));
    connect(currentButton_, &QPushButton::clicked, this, [this] { emit picked(currentAngles_->angles); });
    for (std::size_t i = 0; i < best_.size(); ++i) {
        best_[i] = anglesButton();
        row->addWidget(best_[i]);
        connect(best_[i], &QPushButton::clicked, this, [this, i] { emit picked(map_->best[i].angles); });
    }
    row->addStretch(1);
    return row;
}

QLayout* AngleDialog::makeLimitFields(const GantryLimits& limits)
{
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    row->addWidget(roleLabel("label", tr("Gantry limits")));
    const std::array names{"RAO", "LAO", "CAU", "CRA"};
    const std::array values{-limits.primary.fromDeg, limits.primary.toDeg, -limits.secondary.fromDeg,
                            limits.secondary.toDeg};
    for (std::size_t i = 0; i < limits_.size(); ++i) {
        limits_[i] = new NumberField({0.0, i < 2 ? 180.0 : 90.0, 0, QStringLiteral("°"), 5.0});
        limits_[i]->setAccessibleName(tr("Gantry limits") + QLatin1Char(' ') + QLatin1String(names[i]));
        limits_[i]->showValue(values[i]);
        row->addWidget(roleLabel("label", QLatin1String(names[i])));
        row->addWidget(limits_[i]);
        connect(limits_[i], &NumberField::edited, this, &AngleDialog::criteriaChanged);
    }
    row->addStretch(1);
    return row;
}

void AngleDialog::showBranch(const QString& title, const QString& hint)
{
    title_->setText(title);
    hint_->setText(hint);
    hint_->setVisible(!hint.isEmpty());
}

void AngleDialog::showMap(const std::optional<core::AngleMap>& map, const std::optional<core::AngleSuggestion>& current)
{
    map_ = map;
    currentAngles_ = current;
    plot_->showMap(map);
    plot_->showCurrent(current ? std::optional(current->angles) : std::nullopt);
    currentButton_->setVisible(current.has_value());
    currentButton_->setText(current ? tr("Current: %1").arg(angleText(current->angles)) : QString());
    for (std::size_t i = 0; i < best_.size(); ++i) {
        const bool hasSuggestion = map && i < map->best.size();
        best_[i]->setVisible(hasSuggestion);
        best_[i]->setText(hasSuggestion ? QStringLiteral("%1   %2").arg(i + 1).arg(angleText(map->best[i].angles))
                                        : QString());
    }
    if (!map) {
        picked_->clear();
    }
}

void AngleDialog::showPicked(const core::AngleSuggestion& picked)
{
    plot_->showPicked(picked.angles);
    picked_->setText(tr("%1: foreshortening %2 %, overlap %3 %")
                         .arg(angleText(picked.angles), numberText(100.0 * picked.quality.foreshortening, 0),
                              numberText(100.0 * picked.quality.overlap, 0)));
}

void AngleDialog::showVessels(std::shared_ptr<const core::VesselTree> tree, int branchId,
                              const std::optional<core::PosedCamera>& sight)
{
    view_->showVessels(std::move(tree), branchId, sight);
}

bool AngleDialog::isTakeOff() const
{
    return originOnly_->isChecked();
}

GantryLimits AngleDialog::limits() const
{
    const auto deg = [this](std::size_t i) { return limits_[i]->value().value_or(0.0); };
    return {{-deg(0), deg(1)}, {-deg(2), deg(3)}};
}

}   // namespace angiopose::ui
