#pragma once

#include "core/case/case.h"
#include "ui/panels/step_bar.h"

namespace angiopose::app {

/// Inputs of the step states other than the case itself.
struct StepInputs {
    QString targetProblem;   ///< reason why the frame could not be traced; empty if there is none
    QString targetWarning;   ///< warning that the traced curves may not be vessels; empty if there is none
    bool isTracing = false;
    bool isRunning = false;
    bool poseEdited = false;   ///< true if the pose differs from the initial pose
    int treePieces = 0;   ///< number of connected components of the tree; 0 if not yet known
    bool exported = false;   ///< true if the current pose has been exported
};

/// Returns the state and a short hint of each step for the step bar.
std::array<ui::StepState, ui::stepCount> stepStates(const core::Case& current, const StepInputs& inputs);

}   // namespace angiopose::app
