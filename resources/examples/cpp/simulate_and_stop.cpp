// A case with known answer: how good is the true pose, how good is the one found, and what Stop leaves.
#include <angiopose/angiopose.h>

#include <iostream>

int main()
{
    const angiopose::SimulatedCase simulated = angiopose::simulateCase(7);
    const angiopose::RegistrationInput input = angiopose::inputOf(simulated.session);   // traces the angiogram

    const auto truth = angiopose::evaluatePose(input, simulated.trueCameraFromPatient);
    std::cout << "true pose: median " << truth.metrics.medianPx << " px\n";

    const auto options = angiopose::RegistrationOptions().set("maxIterations", 40).set("search", "on");
    const auto found = angiopose::registerVessels(input, options);
    std::cout << "found:     median " << found.metrics.medianPx << " px\n";

    int reports = 0;
    const auto stopped = angiopose::registerVessels(input, options, [&reports](const angiopose::Progress&) {
        return ++reports == 3 ? angiopose::Verdict::Stop : angiopose::Verdict::Continue;
    });
    std::cout << "stopped:   median " << stopped.metrics.medianPx << " px after " << reports << " reports\n";
    return stopped.stopReason == angiopose::StopReason::StoppedByUser ? 0 : 1;
}
