#pragma once

#include "core/registration/pose/tree_shift.h"
#include "core/registration/problem/registration_problem.h"

namespace angiopose::core {

/// Forwards the reports of a method to the observer and records them for the convergence plot.
class ProgressLog {
public:
    /// Measures the first step from the problem's initial pose.
    ProgressLog(const RegistrationProblem& problem, const IterationObserver& observe)
        : observe_(observe), shift_(problem.tree.points), lastPose_(problem.start)
    {
    }

    /// Forwards a report with its step number and step length, without letting the progress decrease. After the
    /// observer has returned Stop, always returns Stop.
    ObserverDecision report(IterationReport report);

    /// Checks for a stop request while the pose is unchanged: forwards the last report again, with another stage if
    /// given, and does not record it.
    ObserverDecision checkForStop(std::string_view stage = {});

    bool isStopped() const { return isStopped_; }
    int iterations() const { return static_cast<int>(history_.size()); }
    const std::vector<IterationReport>& history() const { return history_; }

private:
    const IterationObserver& observe_;
    TreeShift shift_;
    RigidTransform lastPose_;   ///< cameraFromPatient of the previous report
    std::vector<IterationReport> history_;
    double progress_ = 0.0;
    bool isStopped_ = false;
};

}   // namespace angiopose::core
