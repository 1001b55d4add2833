#pragma once

#include "core/case/case.h"
#include "ui/panels/step_bar.h"

namespace angiopose::app {

/// What the steps need to know beside the case.
struct StepFacts {
    QString targetProblem;   ///< why the frame could not be traced; empty when fine
    QString targetWarning;   ///< that what was traced may be no vessels; empty when fine
    bool isTracing = false;
    bool isRunning = false;
    bool poseEdited = false;   ///< the pose differs from the start pose
    int treePieces = 0;   ///< that do not touch one another; 0: not known yet
    bool exported = false;   ///< the pose as it is has been exported
};

/// Marks and hints of the step bar: true now, in few words.
std::array<ui::StepState, ui::stepCount> stepStates(const core::Case& current, const StepFacts& facts);

}   // namespace angiopose::app