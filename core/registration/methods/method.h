#pragma once

#include "core/registration/matching/target_lines.h"
#include "core/registration/problem/progress_log.h"
#include "core/registration/problem/registration_problem.h"

#include <memory>
#include <span>

namespace angiopose::core {

/// What a method hands back; registerVessels judges the pose.
struct MethodSolution {
    RigidTransform cameraFromPatient;   ///< the best pose found, also after a stop
    StopReason stopReason = StopReason::IterationLimit;
    int iterations = 0;
    std::vector<Hypothesis> alternatives;   ///< best first, without the solution; empty when the method seeks none
    Messages warnings;   ///< what only the method can know
    StageTimes time;   ///< totalMs stays 0
    std::shared_ptr<const TargetLines> targetLines;   ///< if the method built them, for judging
    std::optional<double> agreement;   ///< of the pose, see AgreementScore; if the method found it, for judging
    bool isSettled = false;   ///< refined by the residuals that judge it: it cannot slide to a better place close by
};

/// Solves a checked problem. Reports every iteration to `progress` and returns at once when told to stop.
using MethodSolver = MethodSolution(const RegistrationProblem& problem, const RegistrationOptions& options,
                                    ProgressLog& progress);

/// One row of the table of methods.
struct Method {
    MethodInfo info;
    MethodSolver* solve = nullptr;
    bool heedsLocks = true;   ///< can leave locked degrees of freedom as they are
};

/// Every method that runs, the default first.
std::span<const Method> methods();

/// The method with this id, or null.
const Method* findMethod(std::string_view id);

}   // namespace angiopose::core