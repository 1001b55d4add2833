#include "ui/plots/convergence_plot.h"

#include "ui/controls/stable_minimum_height.h"
#include "ui/theme/active_theme.h"
#include "ui/words/number.h"
#include "ui/words/retranslation.h"

#include <QPainter>
#include <QPolygonF>
#include <algorithm>
#include <cmath>

namespace angiopose::ui {
namespace {

constexpr double captionHeight = 17.0;
constexpr double sampleWidth = 18.0;   // length of the line sample next to the caption
constexpr double maxDecades = 4.0;   // maximum number of decades; smaller values are negligible

/// Paints the caption of a lane above the lane, after a sample of the line.
void paintCaption(QPainter& painter, const QRectF& area, const LogLane& lane)
{
    const double middle = std::round(area.top() + captionHeight / 2.0) + 0.5;
    painter.setPen(lane.pen);
    painter.drawLine(QPointF(area.left(), middle), QPointF(area.left() + sampleWidth, middle));
    painter.setPen(toQColor(activePalette().label));
    const QRectF captionRect(area.left() + sampleWidth + 6.0, area.top(), area.width() - sampleWidth - 6.0,
                             captionHeight);
    const QString text =
        painter.fontMetrics().elidedText(lane.caption, Qt::ElideRight, static_cast<int>(captionRect.width()));
    painter.drawText(captionRect, Qt::AlignLeft | Qt::AlignVCenter, text);
}

/// Paints a labeled grid line at every power of ten (10, 1, 0.1 …).
void paintDecades(QPainter& painter, const QRectF& area, const LogRange& span, const QString& unit)
{
    const Palette& colors = activePalette();
    for (double level = std::ceil(span.bottom); level <= span.top; level += 1.0) {
        const double y = std::round(area.bottom() - (level - span.bottom) / (span.top - span.bottom) * area.height());
        painter.setPen(toQColor(colors.line));
        painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
        if (y - 15.0 >= area.top() - captionHeight) {
            painter.setPen(toQColor(colors.hint));
            painter.drawText(QRectF(area.right() - 80.0, y - 15.0, 78.0, 14.0), Qt::AlignRight | Qt::AlignBottom,
                             QStringLiteral("%1 %2").arg(briefNumber(std::pow(10.0, level), 3), unit));
        }
    }
}

constexpr double axisHeight = 15.0;
constexpr double laneGap = 5.0;   // gap between the lanes
constexpr int emptyConvergenceHeight = 34;   // height before the first registration
constexpr int fullConvergenceHeight = 148;

/// Labels the first and the last step on the x axis.
void paintAxis(QPainter& painter, const QRectF& captionRect, int first, int last)
{
    painter.setPen(toQColor(activePalette().hint));
    painter.drawText(captionRect, Qt::AlignLeft | Qt::AlignBottom, ConvergencePlot::tr("step %1").arg(first));
    painter.drawText(captionRect, Qt::AlignRight | Qt::AlignBottom, QString::number(last));
}

}   // namespace

LogRange logRangeOf(std::span<const double> values)
{
    double lowest = INFINITY, maximum = 0.0;
    for (const double value : values) {
        if (value > 0.0) {
            lowest = std::min(lowest, value);
            maximum = std::max(maximum, value);
        }
    }
    if (maximum <= 0.0) {
        return {-1.0, 0.0};
    }
    const double top = std::max(std::log10(maximum), std::log10(lowest) + 0.9) + 0.05;
    return {std::clamp(std::log10(lowest) - 0.05, top - maxDecades, top - 1.0), top};
}

void paintLane(QPainter& painter, const QRectF& area, const LogLane& lane)
{
    paintCaption(painter, area, lane);
    const QRectF plot = area.adjusted(0.0, captionHeight, 0.0, 0.0);
    const LogRange span = logRangeOf(lane.values);
    paintDecades(painter, plot, span, lane.unit);
    if (lane.values.empty()) {
        return;
    }
    const double first = lane.positions.front();
    const double across = std::max(1.0, lane.positions.back() - first);
    QPolygonF line;
    for (std::size_t i = 0; i < lane.values.size(); ++i) {
        const double level = lane.values[i] > 0.0 ? std::max(std::log10(lane.values[i]), span.bottom) : span.bottom;
        line << QPointF(plot.left() + (lane.positions[i] - first) / across * plot.width(),
                        plot.bottom() - (level - span.bottom) / (span.top - span.bottom) * plot.height());
    }
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(lane.pen);
    painter.drawPolyline(line);
    painter.setRenderHint(QPainter::Antialiasing, false);
}

ConvergencePlot::ConvergencePlot(QWidget* parent)
    : QWidget(parent), height_(new StableMinimumHeight(*this, emptyConvergenceHeight))
{
    withAccessibleName(this, [] { return tr("Convergence"); });
    withToolTip(this, [] {
        return tr(
            "Top: median distance of the vessel points to the traced vessels.\nBottom: displacement of the vessels in "
            "each step (root mean square over all points); the lowest line is zero.");
    });
}

void ConvergencePlot::showHistory(const std::vector<core::IterationReport>& history)
{
    iterations_.clear();
    medianPx_.clear();
    stepMm_.clear();
    height_->requestHeight(emptyConvergenceHeight);
    for (const core::IterationReport& report : history) {
        append(report);
    }
    update();
}

void ConvergencePlot::append(const core::IterationReport& report)
{
    if (std::isfinite(report.medianDistancePx) && std::isfinite(report.stepMm)) {
        iterations_.push_back(report.iteration);
        medianPx_.push_back(report.medianDistancePx);
        stepMm_.push_back(report.stepMm);
    }
    if (iterations_.size() > 1) {
        height_->requestHeight(fullConvergenceHeight);
    }
    update();
}

void ConvergencePlot::paintEvent(QPaintEvent*)
{
    const Palette& colors = activePalette();
    QPainter painter(this);
    const QRectF area = QRectF(rect()).adjusted(0, 0, 0, -2);
    if (iterations_.size() < 2) {
        painter.setPen(toQColor(colors.hint));
        painter.drawText(area, Qt::AlignCenter, tr("shown after a registration"));
        return;
    }
    QFont small = font();
    small.setPixelSize(11);
    painter.setFont(small);
    const double height = (area.height() - axisHeight - laneGap) / 2.0;
    const QRectF upper(area.left(), area.top(), area.width(), height);
    paintLane(
        painter, upper,
        {tr("median distance"), QStringLiteral("px"), QPen(toQColor(colors.accent), 1.5), iterations_, medianPx_});
    paintLane(painter, upper.translated(0.0, height + laneGap),
              {tr("vessel shift per step"), QStringLiteral("mm"), QPen(toQColor(colors.attention), 1.5, Qt::DashLine),
               iterations_, stepMm_});
    paintAxis(painter, QRectF(area.left(), area.bottom() - axisHeight, area.width(), axisHeight), iterations_.front(),
              iterations_.back());
}

}   // namespace angiopose::ui
