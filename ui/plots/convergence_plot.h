#pragma once

#include "core/registration/registration.h"

#include <QPen>
#include <QRectF>
#include <QString>
#include <QWidget>
#include <span>
#include <vector>

class QPainter;

namespace angiopose::ui {

/// Lane of the convergence plot: a curve over decade grid lines, below a caption and a line sample.
struct LogLane {
    QString caption;
    QString unit;
    QPen pen;
    std::span<const int> positions;   ///< x positions, ascending
    std::span<const double> values;   ///< nonnegative; 0 has no logarithm and is drawn at the bottom
};

/// Range of a lane as powers of ten, at least one decade to keep small fluctuations from filling the lane.
struct LogRange {
    double bottom = 0.0, top = 1.0;
};
LogRange logRangeOf(std::span<const double> values);

void paintLane(QPainter& painter, const QRectF& area, const LogLane& lane);

class StableMinimumHeight;

/// Plot of the convergence of a registration in two logarithmic lanes with separate scales: median distance between the
/// tree and the traced vessels, and displacement of the tree, per step.
class ConvergencePlot : public QWidget {
    Q_OBJECT
public:
    explicit ConvergencePlot(QWidget* parent = nullptr);

    void showHistory(const std::vector<core::IterationReport>& history);
    void append(const core::IterationReport& report);
    QSize sizeHint() const override { return {200, 148}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    StableMinimumHeight* height_;
    std::vector<int> iterations_;
    std::vector<double> medianPx_, stepMm_;
};

}   // namespace angiopose::ui
