#pragma once

#include "core/registration/registration.h"

#include <QWidget>

#include <vector>

namespace angiopose::ui {

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