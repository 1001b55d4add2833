// Annotations that AngiogramView draws over its rendering.
#include "ui/actions/key_hint.h"
#include "ui/theme/active_theme.h"
#include "ui/views/angiogram_interaction.h"
#include "ui/views/crosshair_mark.h"
#include "ui/views/paint_marks.h"
#include "ui/views/pivot_mark.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <utility>

namespace angiopose::ui {
namespace {

/// Returns the area of the cutout in widget px; empty without a cutout.
QPainterPath cutoutPath(const Cutout& cutout, const ImageViewport& viewport, const QSizeF& size)
{
    QPainterPath path;
    const Eigen::Vector2d at = viewport.widgetFromImage(cutout.at);
    const double width = size.width();
    constexpr double outside = 4.0;   // extends beyond the widget, so that only the edge of the swipe is visible
    const double height = size.height() + 2.0 * outside;
    if (cutout.shape == Cutout::Shape::Disc) {
        const double radius = cutout.radiusPx * viewport.zoom();
        path.addEllipse(QPointF(at.x(), at.y()), radius, radius);
    } else if (cutout.shape == Cutout::Shape::RightOf && viewport.isMirrored()) {
        path.addRect(QRectF(-outside, -outside, at.x() + outside, height));
    } else if (cutout.shape == Cutout::Shape::RightOf) {
        path.addRect(QRectF(at.x(), -outside, width - at.x() + outside, height));
    }
    return path;
}

/// Draws the edge of the swipe or lens, where the overlay ends.
void paintCutoutEdge(QPainter& painter, const QPainterPath& path)
{
    const Palette& colors = palette(ThemeMode::Dark);   // images have a dark background in every theme
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(toQColor(colors.canvas, 0.6), 3.0));
    painter.drawPath(path);
    painter.setPen(QPen(toQColor(colors.textStrong, 0.8), 1.2));
    painter.drawPath(path);
}

/// Returns an image with faint stripes where the mask is 0.
QImage hatched(const core::Mask2d& fieldMask)
{
    constexpr int period = 8;
    QImage image(fieldMask.width, fieldMask.height, QImage::Format_ARGB32_Premultiplied);
    const QRgb stripe = qPremultiply(toQColor(palette(ThemeMode::Dark).attention, 0.30).rgba());
    const QRgb between = qPremultiply(toQColor(palette(ThemeMode::Dark).attention, 0.07).rgba());
    for (int y = 0; y < fieldMask.height; ++y) {
        auto* row = reinterpret_cast<QRgb*>(image.scanLine(y));
        for (int x = 0; x < fieldMask.width; ++x) {
            row[x] = fieldMask.at(x, y) != 0 ? 0U : (x + y) % period < 2 ? stripe : between;
        }
    }
    return image;
}

}   // namespace

void AngiogramView::setExcludedArea(const core::Mask2d& fieldMask)
{
    interaction_->excludedArea = fieldMask.isEmpty() ? QImage() : hatched(fieldMask);
    redraw();
}

bool AngiogramView::showsVessels() const
{
    return scene_.treeIntersects(interaction_->viewport.imageRectOf({0.0, 0.0}, {1.0 * width(), 1.0 * height()}));
}

void AngiogramView::paintPivot(QPainter& painter) const
{
    const auto place =
        interaction_->pickedPivot && showsVessels() ? positionOf(*interaction_->pickedPivot) : std::nullopt;
    if (place) {
        paintPivotMark(painter, *place, ui::palette(ThemeMode::Dark));
    }
}

void AngiogramView::paintCrosshair(QPainter& painter) const
{
    const ImageCrosshair& crosshair = interaction_->crosshair;
    const auto place = crosshair.pointInPatient ? positionOf(*crosshair.pointInPatient) : std::nullopt;
    if (crosshair.linePx) {
        paintEpipolarLine(painter,
                          {widgetFromImage(crosshair.linePx->beginPx), widgetFromImage(crosshair.linePx->endPx)},
                          ui::palette(ThemeMode::Dark));
    }
    if (place) {
        paintCrosshairMark(painter, *place, ui::palette(ThemeMode::Dark));
    }
}

/// Returns measurements and placed marks in one list, since all labels must avoid each other and the vessels.
std::vector<ImageMark> AngiogramView::visibleMarks() const
{
    if (!interaction_->hasFrame || (interaction_->tool && interaction_->tool->hidesOverlay())) {
        return {};
    }
    std::vector<ImageMark> all = interaction_->marks;
    all.insert(all.end(), interaction_->placedMarks.begin(), interaction_->placedMarks.end());
    return all;
}

/// Paints the labels of the marks; `strokeMarks` has already drawn the lines.
void AngiogramView::paintAllMarks(QPainter& painter) const
{
    const std::vector<ImageMark> all = visibleMarks();
    if (all.empty()) {
        return;
    }
    const auto positionOf = [this](const Eigen::Vector2d& pixel) {
        return interaction_->viewport.widgetFromImage(pixel);
    };
    MarkBackground obstacles;
    obstacles.hasLines = true;
    obstacles.width = width();
    obstacles.height = height();
    for (const QRectF& bar : barRects()) {
        obstacles.occupied.push_back({bar.left(), bar.right(), bar.top(), bar.bottom()});
    }
    if (scene_.mode() != OverlayMode::Hidden) {
        for (const ProjectedBranch& branch : scene_.content().projected) {
            for (const std::vector<ProjectedPoint>& run : branch.runs) {
                for (const ProjectedPoint& point : run) {
                    obstacles.avoided.push_back(positionOf(point.px));
                }
            }
        }
    }
    paintMarks(painter, all, positionOf, std::move(obstacles));
}

void AngiogramView::paintPlaceholder(QPainter& painter) const
{
    const bool isWorking = interaction_->role == ImageRole::Working;
    const int margin = std::min(24, width() / 12);
    painter.setPen(toQColor(ui::palette(ThemeMode::Dark).label));
    painter.drawText(rect().adjusted(margin, margin, -margin, -margin), Qt::AlignCenter | Qt::TextWordWrap,
                     isWorking ? tr("No angiogram yet: drop one here, or open it (%1).").arg(keyOf(Command::Open))
                               : interaction_->absence);
}

/// Returns the review shortcuts if vessels are shown; they apply to the working image.
QString AngiogramView::keyText() const
{
    constexpr int narrowPx = 360;   // narrower views would clip the text
    if (interaction_->role == ImageRole::Working && width() >= narrowPx && showsVessels()) {
        return tr("flicker %1 · swipe %2 · hide H · outline %3")
            .arg(keyOf(Command::Flicker), keyOf(Command::Swipe), keyOf(Command::Outline));
    }
    return {};
}

std::vector<QRectF> AngiogramView::barRects() const
{
    std::vector<QRectF> places;
    for (const QWidget* bar : findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
        if (bar->isVisible()) {
            places.emplace_back(bar->geometry());
        }
    }
    return places;
}

QString AngiogramView::sideMark() const
{
    const bool isMirroredImage = interaction_->camera.fx > 0.0;
    if (isFromSource()) {
        return isMirroredImage ? tr("Mirrored image, mirrored back in this view")
                               : tr("View from the source: mirrored");
    }
    return isMirroredImage ? tr("Mirrored image: seen from the source") : QString();
}

void AngiogramView::updateAnnotations()
{
    AngiogramAnnotations& annotations = interaction_->annotations;
    const ImageTool* tool = interaction_->tool;
    annotations.mmPerImagePx = interaction_->mmPerImagePx();
    annotations.isScaleHidden = scene_.hasDrr() || (tool && tool->hidesOverlay());
    annotations.occupied = annotatedBars_;
    annotations.sides = interaction_->isOrientationKnown
                            ? imageSides(interaction_->camera, interaction_->cameraFromPatient)
                            : ImageSides{};
    if (isFromSource()) {
        std::swap(annotations.sides.left, annotations.sides.right);
    }
    annotations.sideMark = sideMark();
    annotations.frameText = frameText();
    annotations.keyText = keyText();
    annotations.mode = tool ? ModeLabel{tool->caption(), tool->tone()} : ModeLabel{};
}

void AngiogramView::paintOver(QPainter& painter)
{
    if (!interaction_->excludedArea.isNull()) {
        const QPointF topLeft = widgetFromImage({-0.5, -0.5});
        const QSizeF covered = QSizeF(interaction_->excludedArea.size()) * zoom();
        painter.drawImage(QRectF(topLeft, covered), interaction_->excludedArea);
    }
    if (cutout_ != Cutout::Shape::None) {
        paintCutoutEdge(painter, cutoutPath(interaction_->cutout, interaction_->viewport, size()));
    }
    updateAnnotations();
    ui::paintAnnotations(painter, size(), interaction_->annotations, interaction_->viewport, scene_);
    paintPivot(painter);
    paintCrosshair(painter);
    paintAllMarks(painter);
    if (interaction_->tool) {
        painter.setRenderHint(QPainter::Antialiasing);
        interaction_->tool->paint(painter);
    }
}

}   // namespace angiopose::ui
