#include "ui/plots/convergence_plot.h"

#include "ui/controls/lingering_height.h"
#include "ui/plots/log_lane.h"
#include "ui/theme/active_theme.h"
#include "ui/words/spoken.h"

#include <QPainter>

#include <cmath>

namespace angiopose::ui {
namespace {

constexpr double axisHeight = 15.0;
constexpr double laneGap = 5.0;   // between the lanes
constexpr int emptyConvergenceHeight = 34;   // until there was a run, others have the room
constexpr int fullConvergenceHeight = 148;

/// The steps at both ends.
void paintAxis(QPainter& painter, const QRectF& room, int first, int last)
{
    painter.setPen(toQColor(activePalette().hint));
    painter.drawText(room, Qt::AlignLeft | Qt::AlignBottom, ConvergencePlot::tr("step %1").arg(first));
    painter.drawText(room, Qt::AlignRight | Qt::AlignBottom, QString::number(last));
}

}   // namespace

ConvergencePlot::ConvergencePlot(QWidget* parent)
    : QWidget(parent), height_(new LingeringHeight(*this, emptyConvergenceHeight))
{
    withName(this, [] { return tr("Convergence"); });
    withTip(this, [] {
        return tr(
            "Above: half of the vessel points lie nearer than this to the traced vessels.\n"
            "Below: how far a step moved the vessels, root of the mean square over all points; the bottom "
            "line is no shift.");
    });
}

void ConvergencePlot::showHistory(const std::vector<core::IterationReport>& history)
{
    iterations_.clear();
    medianPx_.clear();
    stepMm_.clear();
    height_->ask(emptyConvergenceHeight);
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
        height_->ask(fullConvergenceHeight);
    }
    update();
}

void ConvergencePlot::paintEvent(QPaintEvent*)
{
    const Palette& tones = activePalette();
    QPainter painter(this);
    const QRectF area = QRectF(rect()).adjusted(0, 0, 0, -2);
    if (iterations_.size() < 2) {
        painter.setPen(toQColor(tones.hint));
        painter.drawText(area, Qt::AlignCenter, tr("shown after a run"));
        return;
    }
    QFont small = font();
    small.setPixelSize(11);
    painter.setFont(small);
    const double height = (area.height() - axisHeight - laneGap) / 2.0;
    const QRectF upper(area.left(), area.top(), area.width(), height);
    paintLane(painter, upper,
              {tr("median distance"), QStringLiteral("px"), QPen(toQColor(tones.accent), 1.5), iterations_, medianPx_});
    paintLane(painter, upper.translated(0.0, height + laneGap),
              {tr("shift of the vessels in one step"), QStringLiteral("mm"),
               QPen(toQColor(tones.attention), 1.5, Qt::DashLine), iterations_, stepMm_});
    paintAxis(painter, QRectF(area.left(), area.bottom() - axisHeight, area.width(), axisHeight), iterations_.front(),
              iterations_.back());
}

}   // namespace angiopose::ui