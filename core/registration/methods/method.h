#pragma once

#include "core/registration/methods/method_info.h"
#include "core/registration/problem/method_solution.h"
#include "core/registration/problem/progress_log.h"
#include "core/registration/problem/registration_problem.h"

#include <span>

namespace angiopose::core {

/// Solves a validated problem. Reports every iteration to `progress` and returns immediately on a stop request.
using MethodSolver = MethodSolution(const RegistrationProblem& problem, const RegistrationOptions& options,
                                    ProgressLog& progress);

/// Row of the method table.
struct Method {
    MethodInfo info;
    MethodSolver* solve = nullptr;
    bool respectsLocks = true;   ///< whether the method keeps locked degrees of freedom unchanged
};

/// Returns all available methods, the default first.
std::span<const Method> methods();

/// Returns the method with this id, or null.
const Method* findMethod(std::string_view id);

}   // namespace angiopose::core
