#pragma once

#include "core/case/case.h"
#include "ui/panels/step_bar.h"

namespace angiopose::app {

/// State that the steps depend on in addition to the case.
struct StepFacts {
    QString targetProblem;   ///< reason why the frame could not be traced; empty: none
    QString targetWarning;   ///< warning that the traced curves may not be vessels; empty: none
    bool isTracing = false;
    bool isRunning = false;
    bool poseEdited = false;   ///< the pose differs from the initial pose
    int treePieces = 0;   ///< number of disconnected components; 0: not yet known
    bool exported = false;   ///< the current pose has been exported
};

/// Marks and short hints of the step bar for the current state.
std::array<ui::StepState, ui::stepCount> stepStates(const core::Case& current, const StepFacts& facts);

}   // namespace angiopose::app