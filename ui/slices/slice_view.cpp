#include "ui/slices/slice_view.h"

#include "ui/slices/slice_annotations.h"
#include "ui/slices/slice_measures.h"
#include "ui/slices/slice_tool.h"
#include "ui/theme/active_theme.h"
#include "ui/words/number.h"
#include "ui/words/retranslation.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace angiopose::ui {
namespace {

constexpr double aloneOpacity = 0.6;   // opacity of mask tints without a scan
constexpr double tintOpacity = 0.28;

Eigen::Vector2d pointVector(const QPointF& point)
{
    return {point.x(), point.y()};
}

/// Formats a point in LPS, mm: +x left, +y posterior, +z superior.
QString positionText(const Eigen::Vector3d& point)
{
    return SliceView::tr("x %1  y %2  z %3 mm")
        .arg(numberText(point.x(), 1))
        .arg(numberText(point.y(), 1))
        .arg(numberText(point.z(), 1));
}

}   // namespace

SliceView::SliceView(SliceModel& model, core::BodyPlane plane, QWidget* parent)
    : QWidget(parent), model_(model), plane_(plane)
{
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAttribute(Qt::WA_OpaquePaintEvent);
    keepTranslated(this, [this] {
        setAccessibleName(nameOf(plane_));
        update();
    });
    connect(&model, &SliceModel::scanChanged, this, [this] {
        isContentStale_ = true;
        fit();
    });
    connect(&model, &SliceModel::maskChanged, this, [this] {
        isContentStale_ = true;
        update();
    });
    connect(&model, &SliceModel::maskEdited, this, &SliceView::updateMaskTint);
    connect(&model, &SliceModel::crosshairChanged, this, qOverload<>(&QWidget::update));
    connect(&model, &SliceModel::overlayChanged, this, qOverload<>(&QWidget::update));
    connect(&model, &SliceModel::toolChanged, this, &SliceView::followTool);
    connect(&model, &SliceModel::toolAppearanceChanged, this, qOverload<>(&QWidget::update));
    connect(&model, &SliceModel::appearanceChanged, this, [this] {
        isImageStale_ = true;
        update();
    });
}

void SliceView::setPlane(core::BodyPlane plane)
{
    if (plane != plane_) {
        plane_ = plane;
        setAccessibleName(nameOf(plane));
        isContentStale_ = true;
        fit();
    }
}

void SliceView::fit()
{
    resample();
    const core::SliceGrid& grid = content_.grid;
    if (grid.width > 0) {
        const double unitMm = pixelSizeMm(grid);
        viewport_.setImageSize(static_cast<int>(std::lround(grid.width * grid.columnStep.norm() / unitMm)),
                               static_cast<int>(std::lround(grid.height * grid.rowStep.norm() / unitMm)));
    }
    viewport_.fit();
    isImageStale_ = true;
    update();
}

void SliceView::resample()
{
    const core::VolumeGeometry* geometry = model_.geometry();
    if (!geometry) {
        content_ = {};
        isImageStale_ = true;
        return;
    }
    const core::SliceGrid grid = core::sliceThrough(*geometry, plane_, model_.crosshair());
    if (!isContentStale_ && grid == content_.grid) {
        return;
    }
    content_.grid = grid;
    content_.values = model_.volume() ? core::sliceValues(*model_.volume(), grid) : std::vector<float>{};
    content_.mask = model_.mask() ? core::sliceMask(*model_.mask(), grid) : std::vector<std::uint8_t>{};
    isContentStale_ = false;
    isImageStale_ = true;
}

const core::SliceGrid& SliceView::grid()
{
    resample();
    return content_.grid;
}

void SliceView::renderImage()
{
    const double ratio = devicePixelRatio();
    const QSize deviceSize = (QSizeF(size()) * ratio).toSize();
    if (!isImageStale_ && image_.size() == deviceSize) {
        return;
    }
    image_ = sliceImage(content_, model_.window(), tints(), viewport_, deviceSize, ratio);
    image_.setDevicePixelRatio(ratio);
    isImageStale_ = false;
}

SliceTints SliceView::tints() const
{
    const Palette& colors = ui::palette(ThemeMode::Dark);
    const double opacity = content_.values.empty() ? aloneOpacity : model_.maskOpacity();
    std::vector<MaskTint> mask = model_.labelTints();
    for (MaskTint& tint : mask) {   // label opacities are those for display without a scan
        tint.opacity *= opacity / aloneOpacity;
    }
    if (mask.empty()) {
        mask.push_back({colors.accent, opacity});
    }
    const double previewOpacity = content_.values.empty() ? aloneOpacity : tintOpacity;
    return {std::move(mask), {colors.attention, previewOpacity}, model_.previewFrom()};
}

/// Resamples only the mask and repaints only the screen rows where the mask changed.
void SliceView::updateMaskTint(const core::BoundingBox& box)
{
    const core::SliceGrid& grid = content_.grid;
    if (isContentStale_ || !model_.mask() || grid.width == 0) {
        return;
    }
    const double low = grid.distanceMm(box.lowInPatient);   // corners suffice because normals are patient axes
    const double high = grid.distanceMm(box.highInPatient);
    if (std::max(low, high) < -0.5 * grid.thicknessMm || std::min(low, high) > 0.5 * grid.thicknessMm) {
        return;
    }
    content_.mask = core::sliceMask(*model_.mask(), grid);
    if (!isImageStale_ && !image_.isNull()) {
        const double ratio = devicePixelRatio();
        const double a = widgetFromPatient(box.lowInPatient).y() * ratio;
        const double b = widgetFromPatient(box.highInPatient).y() * ratio;
        const int margin = static_cast<int>(std::ceil(2.0 * pxPerMm() * ratio * grid.rowStep.norm()));
        const int first = std::clamp(static_cast<int>(std::floor(std::min(a, b))) - margin, 0, image_.height());
        const int end = std::clamp(static_cast<int>(std::ceil(std::max(a, b))) + margin, 0, image_.height());
        repaintSliceRows(image_, {first, end}, content_, model_.window(), tints(), viewport_, ratio);
    }
    update();
}

void SliceView::paintEvent(QPaintEvent*)
{
    resample();
    renderImage();
    QPainter painter(this);
    painter.drawImage(QPointF(0, 0), image_);
    const Palette& colors = ui::palette(ThemeMode::Dark);
    if (!model_.hasScan()) {
        painter.setPen(toQColor(colors.label));
        painter.drawText(rect(), Qt::AlignCenter, tr("No scan"));
        return;
    }
    painter.setRenderHint(QPainter::Antialiasing);
    const SliceOverlay overlay{model_, content_.grid, plane_,
                               [this](const Eigen::Vector3d& point) { return widgetFromPatient(point); }, rect()};
    paintBranches(painter, overlay);
    paintPoints(painter, overlay);
    paintMeasurements(painter, overlay);
    paintCrosshair(painter, overlay);
    const CornerAreas occupied = paintTexts(painter, rect(), topTexts(), positionTexts());
    paintSides(painter, overlay, occupied);
    if (const SliceTool* tool = model_.tool()) {
        tool->paint(painter, *this);
    }
    if (hasFocus()) {
        painter.setPen(QPen(toQColor(colors.accent, 0.7), 1.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

QString SliceView::sliceText() const
{
    const core::VolumeGeometry& geometry = *model_.geometry();
    return tr("%1 %2 / %3")
        .arg(nameOf(plane_))
        .arg(core::sliceIndex(geometry, plane_, model_.crosshair()) + 1)
        .arg(core::sliceCount(geometry, plane_));
}

/// Returns text with the slice position and the mouse action of the current mode.
QStringList SliceView::topTexts() const
{
    QStringList texts{sliceText()};
    if (model_.tool() && pointer_) {
        texts += captionLines(model_.tool()->caption(), width());
    }
    return texts;
}

/// Returns text with the value and position at the pointer or, if the pointer is elsewhere, at the crosshair.
QStringList SliceView::positionTexts() const
{
    const Eigen::Vector3d at = pointer_ ? patientFromWidget(*pointer_) : model_.crosshair();
    const QString label = model_.labelNameAt(at);
    const QStringList labels = label.isEmpty() ? QStringList() : QStringList(label);
    if (!model_.volume()) {
        return labels + QStringList(positionText(at));
    }
    const auto value = core::valueAt(*model_.volume(), at);
    const QString number = !value                  ? tr("outside")
                           : model_.isHounsfield() ? tr("%1 HU").arg(numberText(*value, 0))
                                                   : numberText(*value, 0);
    const QString window =
        tr("W %1 L %2").arg(numberText(model_.window().width, 0)).arg(numberText(model_.window().level, 0));
    return labels + QStringList{number + QStringLiteral(" · ") + window, positionText(at)};
}

double SliceView::pxPerMm() const
{
    return viewport_.zoom() / pixelSizeMm(content_.grid);
}

QPointF SliceView::widgetFromPatient(const Eigen::Vector3d& pointInPatient) const
{
    const core::SliceGrid& grid = content_.grid;
    const double unitMm = pixelSizeMm(grid);
    const Eigen::Vector2d pixel = grid.pixelOf(pointInPatient);
    const Eigen::Vector2d at = viewport_.widgetFromImage(
        {pixel.x() * grid.columnStep.norm() / unitMm, pixel.y() * grid.rowStep.norm() / unitMm});
    return {at.x(), at.y()};
}

Eigen::Vector3d SliceView::patientFromWidget(const QPointF& position) const
{
    const core::SliceGrid& grid = content_.grid;
    const double unitMm = pixelSizeMm(grid);
    const Eigen::Vector2d at = viewport_.imageFromWidget(pointVector(position));
    return grid.pointAt({at.x() * unitMm / grid.columnStep.norm(), at.y() * unitMm / grid.rowStep.norm()});
}

}   // namespace angiopose::ui
