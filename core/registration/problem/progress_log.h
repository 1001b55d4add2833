#pragma once

#include "core/registration/pose/tree_shift.h"
#include "core/registration/problem/registration_problem.h"

namespace angiopose::core {

/// Carries the reports of a method to the observer and keeps them for the convergence plot.
class ProgressLog {
public:
    /// Steps are counted from the problem's start pose.
    ProgressLog(const RegistrationProblem& problem, const IterationObserver& observe)
        : observe_(observe), shift_(problem.tree.points), last_(problem.start)
    {
    }

    /// Numbers and measures the step, keeps the progress from falling, passes the report on. Once the answer was Stop
    /// it stays Stop.
    Verdict report(IterationReport report);

    /// Asks whether to go on while the pose rests: the last report once more, of another stage where one is given; it
    /// is not kept again.
    Verdict askAgain(std::string_view stage = {});

    bool isStopped() const { return isStopped_; }
    int iterations() const { return static_cast<int>(history_.size()); }
    const std::vector<IterationReport>& history() const { return history_; }

private:
    const IterationObserver& observe_;
    TreeShift shift_;
    RigidTransform last_;   ///< cameraFromPatient of the report before
    std::vector<IterationReport> history_;
    double progress_ = 0.0;
    bool isStopped_ = false;
};

}   // namespace angiopose::core