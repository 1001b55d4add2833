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

/// One curve of a plot over the run: its caption with a sample of its line above, decades behind it.
struct LogLane {
    QString caption;
    QString unit;
    QPen pen;
    std::span<const int> positions;   ///< ascending, across
    std::span<const double> values;   ///< 0 lies on the floor: a logarithm has none
};

/// The decades a lane spans, as powers of ten; at least one, so that what does not change looks so.
struct LogSpan {
    double bottom = 0.0, top = 1.0;
};
LogSpan spanOf(std::span<const double> values);

void paintLane(QPainter& painter, const QRectF& area, const LogLane& lane);

class LingeringHeight;

/// A run step by step, one lane above the other: the median distance of the tree to the traced vessels, and how far
/// the step moved the tree. Both logarithmic, each on a scale of its own.
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
