#pragma once

#include "core/registration/methods/method_info.h"
#include "core/registration/problem/method_solution.h"
#include "core/registration/problem/progress_log.h"
#include "core/registration/problem/registration_problem.h"

#include <span>

namespace angiopose::core {

/// Solves a checked problem. Reports every iteration to `progress` and returns at once when told to stop.
using MethodSolver = MethodSolution(const RegistrationProblem& problem, const RegistrationOptions& options,
                                    ProgressLog& progress);

/// One row of the table of methods.
struct Method {
    MethodInfo info;
    MethodSolver* solve = nullptr;
    bool respectsLocks = true;   ///< can leave locked degrees of freedom as they are
};

/// Every method that runs, the default first.
std::span<const Method> methods();

/// The method with this id, or null.
const Method* findMethod(std::string_view id);

}   // namespace angiopose::core