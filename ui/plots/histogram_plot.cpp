#include "ui/plots/histogram_plot.h"

#include "ui/controls/stable_minimum_height.h"
#include "ui/theme/active_theme.h"
#include "ui/words/number.h"
#include "ui/words/retranslation.h"

#include <QPainter>

#include <algorithm>

namespace angiopose::ui {
namespace {

constexpr int binCount = 22;
constexpr int histogramLabelHeight = 18;
constexpr int emptyHistogramHeight = 34;   // height without data
constexpr int fullHistogramHeight = 92;

}   // namespace

HistogramPlot::HistogramPlot(QWidget* parent)
    : QWidget(parent), height_(new StableMinimumHeight(*this, emptyHistogramHeight))
{
    withAccessibleName(this, [] { return tr("Histogram of residuals"); });
}

void HistogramPlot::showValues(const std::vector<double>& valuesMm, double scaleMaximumMm)
{
    scaleMaximumMm_ = scaleMaximumMm;
    counts_ = valuesMm.empty() ? std::vector<int>{} : histogramCounts(valuesMm, scaleMaximumMm, binCount);
    height_->requestHeight(counts_.empty() ? emptyHistogramHeight : fullHistogramHeight);
    update();
}

void HistogramPlot::paintEvent(QPaintEvent*)
{
    const Palette& colors = activePalette();
    QPainter painter(this);
    if (counts_.empty()) {
        painter.setPen(toQColor(colors.hint));
        painter.drawText(rect(), Qt::AlignCenter, tr("no residuals yet"));
        return;
    }
    const QRectF area = QRectF(rect()).adjusted(0, 2, 0, -histogramLabelHeight);
    painter.setPen(toQColor(colors.line));
    painter.drawLine(area.bottomLeft(), area.bottomRight());
    const double tallest = std::max(1, *std::ranges::max_element(counts_));
    // Leave one slot empty between the scale and the bar for larger values.
    const double slot = area.width() / (binCount + 2);
    for (int i = 0; i <= binCount; ++i) {
        const double height = counts_[static_cast<std::size_t>(i)] / tallest * area.height();
        const double left = area.left() + slot * (i < binCount ? i : binCount + 1);
        painter.fillRect(QRectF(left, area.bottom() - height, slot - 1.0, height),
                         toQColor(i < binCount ? residualColor((i + 0.5) / binCount) : residualColorAboveScale()));
    }
    painter.setPen(toQColor(colors.hint));
    const QRectF labels(area.left(), area.bottom() + 2, area.width(), histogramLabelHeight - 2);
    painter.drawText(labels, Qt::AlignLeft | Qt::AlignTop, QStringLiteral("0"));
    painter.drawText(labels, Qt::AlignHCenter | Qt::AlignTop, numberText(scaleMaximumMm_ / 2.0, 1));
    painter.drawText(labels, Qt::AlignRight | Qt::AlignTop, tr("above %1").arg(numberText(scaleMaximumMm_, 1)));
}

std::vector<int> histogramCounts(const std::vector<double>& values, double maximum, int binCount)
{
    std::vector<int> counts(static_cast<std::size_t>(binCount) + 1, 0);
    for (const double value : values) {
        const double position = maximum > 0.0 ? value / maximum * binCount : binCount;
        const auto bin = static_cast<std::size_t>(std::clamp(position, 0.0, static_cast<double>(binCount)));
        ++counts[bin];
    }
    return counts;
}

}   // namespace angiopose::ui
