#!/usr/bin/env python3
"""Command line module of 3D Slicer; its arguments are those of AngioPoseRegister.xml."""

import argparse
import os
import shutil
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir, "AngioPose"))

from AngioPoseLib import command_line  # noqa: E402


def parsed(words):
    parser = argparse.ArgumentParser(description=__doc__)
    for name in ("vessels", "angiogram", "pose", "seenVessels"):
        parser.add_argument(name)
    parser.add_argument("--method", default="")
    parser.add_argument("--bend", action="store_true")
    for flag in ("--source-to-detector", "--source-to-patient", "--pixel-spacing"):
        parser.add_argument(flag, type=float, default=0.0)
    return parser.parse_args(words)


def geometry_of(arguments):
    spacing = arguments.pixel_spacing
    values = {
        "sourceToDetectorMm": arguments.source_to_detector,
        "sourceToPatientMm": arguments.source_to_patient,
        "imagerPixelSpacingMm": [spacing, spacing] if spacing else 0.0,
    }
    return {key: value for key, value in values.items() if value}


def register(arguments, folder):
    case = os.path.join(folder, "case.angiopose")
    command_line.write_case(case, arguments.vessels, "centerline", arguments.angiogram, geometry_of(arguments))
    outputs = os.path.join(folder, "result")
    result = command_line.register(case, outputs, arguments.method, arguments.bend)
    command_line.write_itk_transform(command_line.inverse(result["pose"]["cameraFromPatient"]), arguments.pose)
    bent = os.path.join(outputs, "bent.vtp")
    if os.path.exists(bent):
        shutil.copyfile(bent, arguments.seenVessels)
    else:
        command_line.run(["convert", arguments.vessels, arguments.seenVessels])
    return result


def main(words):
    arguments = parsed(words)
    with tempfile.TemporaryDirectory(prefix="angiopose-") as folder:
        try:
            result = register(arguments, folder)
        except command_line.RunFailed as failure:
            print(failure, file=sys.stderr)
            return 1
    for warning in result["warnings"]:
        print(warning)
    print("trustworthy" if result["trustworthy"] else "not trustworthy")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
