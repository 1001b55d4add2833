"""An angiogram in, its vessels out as points."""

import sys

import angiopose

if len(sys.argv) != 3:
    sys.exit("usage: trace_image.py ANGIOGRAM CENTRELINE.csv")
run = angiopose.readAngiogram(sys.argv[1])
trace = angiopose.traceFrame(run, run.suggestedFrame)
share = 100 * (trace.vesselMask > 0).mean()
print(f"frame {run.suggestedFrame} of {run.frameCount}: {len(trace.centerline)} points, {share:.1f} % of the image")
print(f"{len(trace.suspectCurves)} curves may be catheters, wires or edges of bones")
angiopose.writeCenterline2d(trace.centerline, sys.argv[2])
