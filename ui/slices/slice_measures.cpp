#include "ui/slices/slice_measures.h"

#include "ui/theme/active_theme.h"
#include "ui/views/paint_marks.h"

#include <QApplication>
#include <QFontMetricsF>
#include <QPainter>

#include <cmath>

namespace angiopose::ui {
namespace {

using core::MeasurementKind;
using core::SliceMeasurement;

constexpr double faint = 0.35;
constexpr double captionMarginPx = 20.0;

double offsetMm(const SliceMeasurement& measurement, const core::SliceGrid& grid)
{
    return std::abs(grid.distanceMm(measurement.pointsInPatient.front()));
}

/// Converts a measurement to a mark in widget px.
ImageMark markOf(const LabeledMeasurement& measurementData, const SliceOverlay& overlay)
{
    const SliceMeasurement& what = measurementData.measurement;
    ImageMark mark;
    mark.shape = what.kind == MeasurementKind::Length  ? MarkShape::Length
                 : what.kind == MeasurementKind::Angle ? MarkShape::Angle
                                                       : MarkShape::Outline;
    for (const Eigen::Vector3d& point : what.pointsInPatient) {
        const QPointF at = overlay.widgetFromPatient(point);
        mark.pixels.emplace_back(at.x(), at.y());
    }
    mark.isSelected = measurementData.isSelected;
    return mark;
}

}   // namespace

bool isInSlice(const SliceMeasurement& measurement, core::BodyPlane plane, const core::SliceGrid& grid)
{
    return measurement.plane == plane && !measurement.pointsInPatient.empty() &&
           offsetMm(measurement, grid) <= 0.5 * grid.thicknessMm;
}

void paintMeasurements(QPainter& painter, const SliceOverlay& overlay)
{
    std::vector<ImageMark> marks;
    std::vector<ImageMark> near;
    for (const LabeledMeasurement& measurementData : overlay.model.measurementData()) {
        const SliceMeasurement& what = measurementData.measurement;
        if (isInSlice(what, overlay.plane, overlay.grid)) {
            marks.push_back(markOf(measurementData, overlay));
            marks.back().label = measurementData.label.toStdString();
        } else if (what.plane == overlay.plane && !what.pointsInPatient.empty() &&
                   offsetMm(what, overlay.grid) <= visibleDistanceMm(overlay.grid)) {
            near.push_back(markOf(measurementData, overlay));
        }
    }
    const auto identity = [](const Eigen::Vector2d& at) { return at; };
    painter.save();
    painter.setOpacity(faint);
    paintMarks(painter, near, identity);
    painter.setOpacity(1.0);
    paintMarks(painter, marks, identity);
    painter.restore();
}

void paintRing(QPainter& painter, const SliceOverlay& overlay, const std::vector<Eigen::Vector3d>& ring)
{
    const double halfMm = 0.5 * overlay.grid.thicknessMm;
    const QColor rim = toQColor(palette(ThemeMode::Dark).canvas, 0.8);
    const QColor tone = toQColor(palette(ThemeMode::Dark).fine);
    std::vector<QLineF> pieces;
    std::vector<QPointF> crossings;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Eigen::Vector3d& from = ring[i];
        const Eigen::Vector3d& to = ring[(i + 1) % ring.size()];
        const double before = overlay.grid.distanceMm(from);
        const double after = overlay.grid.distanceMm(to);
        if (std::abs(before) <= halfMm && std::abs(after) <= halfMm) {
            pieces.emplace_back(overlay.widgetFromPatient(from), overlay.widgetFromPatient(to));
        }
        if ((before <= 0.0) != (after <= 0.0)) {
            const Eigen::Vector3d crossing = from + before / (before - after) * (to - from);
            crossings.push_back(overlay.widgetFromPatient(crossing));
        }
    }
    for (const auto& [color, width] : {std::pair(rim, 4.0), std::pair(tone, 2.0)}) {
        painter.setPen(QPen(color, width, Qt::SolidLine, Qt::RoundCap));
        for (const QLineF& piece : pieces) {
            painter.drawLine(piece);
        }
        if (crossings.size() == 2) {
            painter.setPen(QPen(color, 0.5 * width, Qt::SolidLine, Qt::RoundCap));
            painter.drawLine(QLineF(crossings[0], crossings[1]));
            painter.setPen(QPen(color, 2.5 * width, Qt::SolidLine, Qt::RoundCap));
            painter.drawPoint(crossings[0]);
            painter.drawPoint(crossings[1]);
        }
    }
}

QStringList captionLines(const QString& caption, int widthPx)
{
    const QFontMetricsF metrics(QApplication::font());
    QStringList lines;
    for (const QString& part : caption.split(QStringLiteral(" · "))) {
        const QString longer = lines.isEmpty() ? part : lines.back() + QStringLiteral(" · ") + part;
        if (!lines.isEmpty() && metrics.horizontalAdvance(longer) <= widthPx - captionMarginPx) {
            lines.back() = longer;
        } else {
            lines << part;
        }
    }
    return lines;
}

}   // namespace angiopose::ui
