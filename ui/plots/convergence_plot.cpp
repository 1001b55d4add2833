#include "ui/plots/convergence_plot.h"

#include "ui/theme/active_theme.h"

#include <QPainter>
#include <QPolygonF>

#include <algorithm>
#include <cmath>

namespace ui {

ConvergencePlot::ConvergencePlot(QWidget* parent) : QWidget(parent)
{
    setMinimumHeight(84);
    setAccessibleName(tr("Convergence"));
}

void ConvergencePlot::showHistory(const std::vector<core::IterationReport>& history)
{
    medianPx_.clear();
    for (const core::IterationReport& report : history) {
        append(report);
    }
    update();
}

void ConvergencePlot::append(const core::IterationReport& report)
{
    if (std::isfinite(report.medianDistancePx)) {
        medianPx_.push_back(report.medianDistancePx);
    }
    update();
}

void ConvergencePlot::paintEvent(QPaintEvent*)
{
    const Palette& tones = activePalette();
    QPainter painter(this);
    const QRectF area = QRectF(rect()).adjusted(0, 6, 0, -4);
    painter.setPen(toQColor(tones.line));
    painter.drawLine(area.bottomLeft(), area.bottomRight());
    if (medianPx_.size() < 2) {
        painter.setPen(toQColor(tones.hint));
        painter.drawText(area, Qt::AlignCenter, tr("shown after a run"));
        return;
    }
    const double highest = std::max(1e-9, *std::ranges::max_element(medianPx_));
    QPolygonF line;
    for (std::size_t i = 0; i < medianPx_.size(); ++i) {
        const double x = static_cast<double>(i) / static_cast<double>(medianPx_.size() - 1);
        line << QPointF(area.left() + x * area.width(), area.bottom() - medianPx_[i] / highest * (area.height() - 2.0));
    }
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(toQColor(tones.accent), 1.5));
    painter.drawPolyline(line);
}

}   // namespace ui
