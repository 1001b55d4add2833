"""A case file in, pose and result.json out: what `angiopose-cli register` does."""

import sys

import angiopose


def show(progress: angiopose.Progress) -> None:
    print(f"\r{progress.stage} {100 * progress.fraction:.0f} %   ", end="", file=sys.stderr)


if len(sys.argv) != 3:
    sys.exit("usage: register_case.py CASE.angiopose RESULT.json")
try:
    session = angiopose.readCase(sys.argv[1])
    result = angiopose.registerCase(session, show)
    angiopose.writeResult(session, sys.argv[2])
except angiopose.Error as error:
    sys.exit(str(error))
print(result.cameraFromPatient)
print(f"median {result.metrics.medianPx:.2f} px, {'' if result.trustworthy else 'not '}trustworthy")
for warning in [*session.warnings, *result.warnings]:
    print(warning)
sys.exit(0 if result.trustworthy else 4)
