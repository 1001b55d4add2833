#pragma once

#include "core/registration/registration.h"

#include <QWidget>

#include <vector>

namespace ui {

/// Median distance of the tree to the traced vessels over the steps of the run, logarithmic.
class ConvergencePlot : public QWidget {
    Q_OBJECT
public:
    explicit ConvergencePlot(QWidget* parent = nullptr);

    void showHistory(const std::vector<core::IterationReport>& history);
    void append(const core::IterationReport& report);
    QSize sizeHint() const override { return {200, 84}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void paintDecades(QPainter& painter, const QRectF& area, double bottom, double top) const;

    std::vector<double> medianPx_;
};

}   // namespace ui
