"""A case with known answer: how good is the true pose, how good is the one found, and what Stop leaves."""

import angiopose

simulated = angiopose.simulateCase(7)
problem = angiopose.inputOf(simulated.session)  # traces the angiogram

truth = angiopose.evaluatePose(problem, simulated.trueCameraFromPatient)
print(f"true pose: median {truth.metrics.medianPx:.2f} px")

options = angiopose.RegistrationOptions("angiopose", maxIterations=40, search=True)
found = angiopose.registerVessels(problem, options)
print(f"found:     median {found.metrics.medianPx:.2f} px")

reports = []


def stopAtThird(progress: angiopose.Progress) -> angiopose.Verdict:
    reports.append(progress.stage)
    return angiopose.Verdict.Stop if len(reports) == 3 else angiopose.Verdict.Continue


stopped = angiopose.registerVessels(problem, options, stopAtThird)
print(f"stopped:   median {stopped.metrics.medianPx:.2f} px after {len(reports)} reports, {stopped.stopReason.name}")
