#include "core/registration/registration.h"

#include "core/registration/judging/judge_pose.h"
#include "core/registration/methods/method.h"
#include "core/support/stopwatch.h"

namespace angiopose::core {

Result<RegistrationResult> registerVessels(const RegistrationInput& input, const RegistrationOptions& options,
                                           const IterationObserver& observe)
{
    Stopwatch stopwatch;
    if (const auto unusable = findProblem(options)) {
        return Error(*unusable);
    }
    const Result<RegistrationProblem> problem = makeProblem(input, options);
    if (!problem) {
        return problem.error();
    }
    ProgressLog progress(problem.value(), observe);
    const MethodSolution solution = findMethod(options.method)->solve(problem.value(), options, progress);

    RegistrationResult result = judgePose(problem.value(), options, solution);
    result.method = options.method;
    result.history = progress.history();
    result.time.totalMs = stopwatch.lapMs();
    return result;
}

std::string_view toText(StopReason reason)
{
    switch (reason) {
        case StopReason::Converged:
            return "converged";
        case StopReason::IterationLimit:
            return "iteration limit";
        case StopReason::NoImprovement:
            return "no improvement";
        case StopReason::StoppedByUser:
            return "stopped by the user";
    }
    return "";
}

}   // namespace angiopose::core