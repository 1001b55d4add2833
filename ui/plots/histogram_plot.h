#pragma once

#include <QWidget>

#include <vector>

namespace angiopose::ui {

class LingeringHeight;

/// Residuals of all points as bars in the colours of the overlay's ramp; the last bar holds all that lies above.
class HistogramPlot : public QWidget {
    Q_OBJECT
public:
    explicit HistogramPlot(QWidget* parent = nullptr);

    void showValues(const std::vector<double>& valuesMm, double scaleMaximumMm);
    QSize sizeHint() const override { return {200, 92}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    LingeringHeight* height_;
    std::vector<int> counts_;
    double scaleMaximumMm_ = 0.0;
};

/// Counts in `binCount` equal bins up to `maximum`, and one more for what lies above.
std::vector<int> binned(const std::vector<double>& values, double maximum, int binCount);

}   // namespace angiopose::ui