#include "ui/plots/convergence_plot.h"

#include "ui/theme/active_theme.h"
#include "ui/words/spoken.h"

#include <QPainter>
#include <QPolygonF>

#include <algorithm>
#include <cmath>

namespace ui {
namespace {

constexpr double leastPx = 1e-3;   // a logarithm has no 0

double levelOf(double px)
{
    return std::log10(std::max(px, leastPx));
}

}   // namespace

ConvergencePlot::ConvergencePlot(QWidget* parent) : QWidget(parent)
{
    setMinimumHeight(84);
    withName(this, [] { return tr("Convergence"); });
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
    if (medianPx_.size() < 2) {
        painter.setPen(toQColor(tones.line));
        painter.drawLine(area.bottomLeft(), area.bottomRight());
        painter.setPen(toQColor(tones.hint));
        painter.drawText(area, Qt::AlignCenter, tr("shown after a run"));
        return;
    }
    const auto [lowest, highest] = std::ranges::minmax(medianPx_);
    // At least one decade, so that a run that changes nothing looks like one.
    const double top = std::max(levelOf(highest), levelOf(lowest) + 0.9) + 0.05;
    const double bottom = std::min(levelOf(lowest), top - 1.0) - 0.05;
    const auto heightOf = [&](double level) {
        return area.bottom() - (level - bottom) / (top - bottom) * area.height();
    };
    paintDecades(painter, area, bottom, top);
    QPolygonF line;
    for (std::size_t i = 0; i < medianPx_.size(); ++i) {
        const double x = static_cast<double>(i) / static_cast<double>(medianPx_.size() - 1);
        line << QPointF(area.left() + x * area.width(), heightOf(levelOf(medianPx_[i])));
    }
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(toQColor(tones.accent), 1.5));
    painter.drawPolyline(line);
}

/// A line and its number at 10, 1, 0.1 … px.
void ConvergencePlot::paintDecades(QPainter& painter, const QRectF& area, double bottom, double top) const
{
    const Palette& tones = activePalette();
    QFont small = font();
    small.setPixelSize(11);
    painter.setFont(small);
    for (double level = std::ceil(bottom); level <= top; level += 1.0) {
        const double y = std::round(area.bottom() - (level - bottom) / (top - bottom) * area.height());
        painter.setPen(toQColor(tones.line));
        painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
        painter.setPen(toQColor(tones.hint));
        painter.drawText(QRectF(area.right() - 60.0, y - 15.0, 58.0, 14.0), Qt::AlignRight | Qt::AlignBottom,
                         QStringLiteral("%1 px").arg(std::pow(10.0, level), 0, 'g', 3));
    }
}

}   // namespace ui
