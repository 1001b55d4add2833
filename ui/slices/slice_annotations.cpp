#include "ui/slices/slice_annotations.h"

#include "ui/scenes/branch_style.h"
#include "ui/slices/slice_measures.h"
#include "ui/theme/active_theme.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace angiopose::ui {
namespace {

constexpr double maxDistanceMm = 3.0;
constexpr int letterPx = 12;
constexpr double letterWidthPx = 16.0;
constexpr double letterHeightPx = 16.0;
constexpr double letterGapPx = 2.0;
constexpr int textPx = 11;
constexpr double crosshairGapPx = 9.0;
constexpr double markRadiusPx = 4.5;

/// Returns the palette for annotations; images have a black background in every theme.
const Palette& sliceTones()
{
    return palette(ThemeMode::Dark);
}

QChar sideOf(const Eigen::Vector3d& direction)
{
    Eigen::Index axis = 0;
    direction.cwiseAbs().maxCoeff(&axis);
    const bool isPositive = direction[axis] > 0.0;
    constexpr std::array positive{'L', 'P', 'H'};
    constexpr std::array negative{'R', 'A', 'F'};
    const auto at = static_cast<std::size_t>(axis);
    return QLatin1Char(isPositive ? positive[at] : negative[at]);
}

void drawOutlined(QPainter& painter, const QRectF& box, int flags, const QString& text, const QColor& color)
{
    painter.setPen(toQColor(sliceTones().canvas, 0.85));
    for (const QPointF& shift : {QPointF(1, 1), QPointF(-1, -1)}) {
        painter.drawText(box.translated(shift), flags, text);
    }
    painter.setPen(color);
    painter.drawText(box, flags, text);
}

void drawWithHalo(QPainter& painter, const QLineF& line, const QColor& color, double width)
{
    painter.setPen(QPen(toQColor(sliceTones().canvas, 0.6 * color.alphaF()), width + 1.6, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(line);
    painter.setPen(QPen(color, width, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(line);
}

void paintBranch(QPainter& painter, const SliceOverlay& overlay, const core::VesselBranch& branch)
{
    const BranchStyle style = branchStyle(branch.id, overlay.model.marks());
    const double reach = visibleDistanceMm(overlay.grid);
    const auto& points = branch.pointsInPatient;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const double before = overlay.grid.distanceMm(points[i - 1]);
        const double after = overlay.grid.distanceMm(points[i]);
        const bool crosses = (before <= 0.0) != (after <= 0.0);
        const double nearest = std::min(std::abs(before), std::abs(after));
        if (!crosses && nearest > reach) {
            continue;
        }
        const QPointF from = overlay.widgetFromPatient(points[i - 1]);
        const QPointF to = overlay.widgetFromPatient(points[i]);
        QColor color = toQColor(style.color, style.opacity * (crosses ? 1.0 : 0.15 + 0.75 * (1.0 - nearest / reach)));
        drawWithHalo(painter, {from, to}, color, 1.6 * style.widthFactor);
        if (crosses) {
            const double fraction = before / (before - after);
            const QPointF at = from + fraction * (to - from);
            painter.setPen(QPen(toQColor(sliceTones().canvas, 0.7), 1.0));
            painter.setBrush(toQColor(style.color));
            const double radius = 2.6 * style.widthFactor;
            painter.drawEllipse(at, radius, radius);
        }
    }
}

void paintMark(QPainter& painter, const QPointF& at, SliceMarkKind kind, const QString& label, double opacity)
{
    const bool isFine = kind == SliceMarkKind::Seed || kind == SliceMarkKind::Place;
    const Color tone = isFine                         ? sliceTones().fine
                       : kind == SliceMarkKind::Avoid ? sliceTones().attention
                                                      : sliceTones().accent;
    QPainterPath sign;   // + for seeds, × for avoid points, otherwise a ring
    const double r = markRadiusPx;
    if (kind == SliceMarkKind::Seed) {
        sign.moveTo(at - QPointF(r, 0));
        sign.lineTo(at + QPointF(r, 0));
        sign.moveTo(at - QPointF(0, r));
        sign.lineTo(at + QPointF(0, r));
    } else if (kind == SliceMarkKind::Avoid) {
        sign.moveTo(at - QPointF(r, r));
        sign.lineTo(at + QPointF(r, r));
        sign.moveTo(at + QPointF(-r, r));
        sign.lineTo(at + QPointF(r, -r));
    } else {
        sign.addEllipse(at, r, r);
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(toQColor(sliceTones().canvas, 0.8 * opacity), 4.0));
    painter.drawPath(sign);
    painter.setPen(QPen(toQColor(tone, opacity), 2.0));
    painter.drawPath(sign);
    if (!label.isEmpty()) {
        const double width = QFontMetricsF(painter.font()).horizontalAdvance(label) + 2.0;
        const bool isLeft = at.x() + r + 3 + width > painter.viewport().width();   // avoids clipping
        drawOutlined(painter, QRectF(at + QPointF(isLeft ? -r - 3 - width : r + 3, -8), QSizeF(width, 16)),
                     Qt::AlignLeft | Qt::AlignVCenter, label, toQColor(tone, opacity));
    }
}

/// Returns the box at the middle of an edge, moved right if corner text reaches it, or inward if that fills the edge.
QRectF letterBox(const QRectF& area, double top, const QRectF& occupied)
{
    QRectF box(area.center().x() - 0.5 * letterWidthPx, top, letterWidthPx, letterHeightPx);
    if (!box.intersects(occupied)) {
        return box;
    }
    if (occupied.right() + letterGapPx + letterWidthPx <= area.right()) {
        box.moveLeft(occupied.right() + letterGapPx);
    } else if (top > area.center().y()) {
        box.moveBottom(occupied.top() - letterGapPx);
    } else {
        box.moveTop(occupied.bottom() + letterGapPx);
    }
    return box;
}

}   // namespace

double visibleDistanceMm(const core::SliceGrid& grid)
{
    return std::max(maxDistanceMm, grid.thicknessMm);
}

void paintBranches(QPainter& painter, const SliceOverlay& overlay)
{
    const core::VesselTree* tree = overlay.model.tree();
    if (!tree) {
        return;
    }
    for (const core::VesselBranch& branch : tree->branches) {
        if (!overlay.model.marks().hidden.contains(branch.id)) {
            paintBranch(painter, overlay, branch);
        }
    }
}

void paintPoints(QPainter& painter, const SliceOverlay& overlay)
{
    const double reach = 2.0 * visibleDistanceMm(overlay.grid);
    for (const auto& [kind, marks] : overlay.model.points()) {
        for (const SliceMark& mark : marks) {
            paintRing(painter, overlay, mark.ring);
            const double distance = std::abs(overlay.grid.distanceMm(mark.pointInPatient));
            if (distance <= reach) {
                paintMark(painter, overlay.widgetFromPatient(mark.pointInPatient), kind, mark.label,
                          1.0 - 0.75 * distance / reach);
            }
        }
    }
}

void paintCrosshair(QPainter& painter, const SliceOverlay& overlay)
{
    const QPointF at = overlay.widgetFromPatient(overlay.model.crosshair());
    painter.setPen(QPen(toQColor(sliceTones().accent, 0.55), 1.0));
    const QRectF& area = overlay.area;
    painter.drawLine(QLineF(area.left(), at.y(), at.x() - crosshairGapPx, at.y()));
    painter.drawLine(QLineF(at.x() + crosshairGapPx, at.y(), area.right(), at.y()));
    painter.drawLine(QLineF(at.x(), area.top(), at.x(), at.y() - crosshairGapPx));
    painter.drawLine(QLineF(at.x(), at.y() + crosshairGapPx, at.x(), area.bottom()));
}

void paintSides(QPainter& painter, const SliceOverlay& overlay, const CornerAreas& occupied)
{
    const core::PlaneAxes axes = core::axesOf(overlay.plane);
    QFont font = painter.font();
    font.setPixelSize(letterPx);
    font.setWeight(QFont::DemiBold);
    painter.setFont(font);
    const QRectF area = overlay.area.adjusted(5, 4, -5, -4);
    const QColor color = toQColor(sliceTones().text);
    drawOutlined(painter, area, Qt::AlignLeft | Qt::AlignVCenter, sideOf(-axes.right), color);
    drawOutlined(painter, area, Qt::AlignRight | Qt::AlignVCenter, sideOf(axes.right), color);
    drawOutlined(painter, letterBox(area, area.top(), occupied.top), Qt::AlignCenter, sideOf(-axes.down), color);
    drawOutlined(painter, letterBox(area, area.bottom() - letterHeightPx, occupied.bottom), Qt::AlignCenter,
                 sideOf(axes.down), color);
}

CornerAreas paintTexts(QPainter& painter, const QRectF& area, const QStringList& top, const QStringList& bottom)
{
    QFont font = painter.font();
    font.setPixelSize(textPx);
    font.setWeight(QFont::Normal);
    painter.setFont(font);
    const QColor color = toQColor(sliceTones().text);
    const QRectF inner = area.adjusted(8, 6, -8, -6);
    const QFontMetricsF metrics(font);
    const auto fitted = [&](QStringList lines) {
        for (QString& line : lines) {
            line = metrics.elidedText(line, Qt::ElideRight, inner.width());
        }
        return lines.join(QLatin1Char('\n'));
    };
    const QString above = fitted(top);
    const QString below = fitted(bottom);
    drawOutlined(painter, inner, Qt::AlignLeft | Qt::AlignTop, above, color);
    drawOutlined(painter, inner, Qt::AlignLeft | Qt::AlignBottom, below, color);
    return {metrics.boundingRect(inner, Qt::AlignLeft | Qt::AlignTop, above),
            metrics.boundingRect(inner, Qt::AlignLeft | Qt::AlignBottom, below)};
}

}   // namespace angiopose::ui
