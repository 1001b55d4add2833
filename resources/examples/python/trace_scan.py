"""A CT angiogram (file or DICOM folder), a label image or a surface in, a vessel tree out."""

import sys

import angiopose


def show(progress: angiopose.Progress) -> None:
    print(f"\r{100 * progress.fraction:.0f} %", end="", file=sys.stderr)  # return Verdict.Stop to end it


if len(sys.argv) != 3:
    sys.exit("usage: trace_scan.py SCAN TREE.vtp")
options = angiopose.VesselReadOptions(tracing=angiopose.VesselTracingOptions(minBranchLengthMm=5.0))
vessels = angiopose.readVessels(sys.argv[1], options, show)
for warning in vessels.warnings:
    print(warning)
print(f"{len(vessels.tree)} points, lumen above {vessels.threshold:.0f}")
angiopose.writeVesselTree(vessels.tree, sys.argv[2])
