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

/// One curve of the convergence plot: a caption with a line sample above it, decade lines behind it.
struct LogLane {
    QString caption;
    QString unit;
    QPen pen;
    std::span<const int> positions;   ///< x positions, ascending
    std::span<const double> values;   ///< 0 is drawn at the bottom: it has no logarithm
};

/// Range of a lane as powers of ten; at least one decade, which keeps constant values looking constant.
struct LogSpan {
    double bottom = 0.0, top = 1.0;
};
LogSpan spanOf(std::span<const double> values);

void paintLane(QPainter& painter, const QRectF& area, const LogLane& lane);

class LingeringHeight;

/// Convergence of a registration in two lanes over its steps: the median distance of the tree to the traced vessels,
/// and the movement of the tree per step. Both are logarithmic with separate scales.
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
    LingeringHeight* height_;
    std::vector<int> iterations_;
    std::vector<double> medianPx_, stepMm_;
};

}   // namespace angiopose::ui
