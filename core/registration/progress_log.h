#pragma once

#include "core/registration/registration.h"

namespace core {

/// Carries the reports of a method to the observer and keeps them for the convergence plot.
class ProgressLog {
public:
    explicit ProgressLog(const IterationObserver& observe) : observe_(observe) {}

    /// Numbers the report, keeps its progress from falling, passes it on. Once the answer was Stop it stays Stop.
    Verdict report(IterationReport report);

    bool isStopped() const { return isStopped_; }
    int iterations() const { return static_cast<int>(history_.size()); }
    const std::vector<IterationReport>& history() const { return history_; }

private:
    const IterationObserver& observe_;
    std::vector<IterationReport> history_;
    double progress_ = 0.0;
    bool isStopped_ = false;
};

}   // namespace core
