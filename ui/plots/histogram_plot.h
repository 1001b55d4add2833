#pragma once

#include <QWidget>

#include <vector>

namespace angiopose::ui {

class StableMinimumHeight;

/// Histogram of the residuals of all points, in the colors of the overlay; the last bar counts values above the scale.
class HistogramPlot : public QWidget {
    Q_OBJECT
public:
    explicit HistogramPlot(QWidget* parent = nullptr);

    void showValues(const std::vector<double>& valuesMm, double scaleMaximumMm);
    QSize sizeHint() const override { return {200, 92}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    StableMinimumHeight* height_;
    std::vector<int> counts_;
    double scaleMaximumMm_ = 0.0;
};

/// Counts values in `binCount` equal bins up to `maximum`, plus one bin for larger values.
std::vector<int> histogramCounts(const std::vector<double>& values, double maximum, int binCount);

}   // namespace angiopose::ui
