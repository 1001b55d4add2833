"""Cases and runs of angiopose-cli, and what they left. Points are LPS mm here."""

import hashlib
import json
import os
import shutil
import subprocess

NOT_TRUSTWORTHY = 4  # exit code of a run that found a pose that is not to be trusted


class RunFailed(Exception):
    """angiopose-cli gave no result; the sentence is its own."""


def program():
    found = os.environ.get("ANGIOPOSE_CLI") or shutil.which("angiopose-cli")
    if not found:
        raise RunFailed("angiopose-cli was not found. Install AngioPose, or set ANGIOPOSE_CLI to its path.")
    return found


def run(arguments):
    """Its standard output. Libraries that Slicer puts first in the search path are not for it."""
    environment = {key: value for key, value in os.environ.items() if key not in ("LD_LIBRARY_PATH", "PYTHONHOME", "PYTHONPATH")}
    done = subprocess.run([program(), *map(str, arguments)], capture_output=True, text=True, env=environment)
    if done.returncode not in (0, NOT_TRUSTWORTHY):
        raise RunFailed(done.stderr.strip() or f"angiopose-cli ended with {done.returncode}.")
    return done.stdout


def sha256(path):
    with open(path, "rb") as file:
        return hashlib.sha256(file.read()).hexdigest()


def write_case(path, vessels, kind, angiogram, geometry=None, points=(), title=""):
    """A case file. kind: centerline, segmentation, surface or volume; points: (name, (x, y, z)); geometry: keys of
    FORMATS §2.4, for what the header of the angiogram lacks."""
    folder = os.path.dirname(os.path.abspath(path))

    def entry(file):
        return {"path": os.path.relpath(file, folder), "sha256": sha256(file)}

    marks = [
        {"id": number, "kind": "check-point", "name": name, "pointInPatientMm": list(place)}
        for number, (name, place) in enumerate(points, start=1)
    ]
    case = {
        "format": "angiopose-case",
        "version": 1,
        "title": title,
        "vessel": {kind: entry(vessels)},
        "angiogram": {"image": entry(angiogram)},
    }
    if marks:
        case["vessel"]["marks"] = marks
    if geometry:
        case["geometry"] = dict(geometry)
    with open(path, "w", encoding="utf-8") as file:
        json.dump(case, file, indent=2)


def register(case, folder, method=None, bends=False, frame=None):
    """Registers a case into a folder (`frame` from 0, as in its file); the content of its result.json."""
    arguments = ["register", case, "--output", folder]
    if method:
        arguments += ["--method", method]
    if bends:
        arguments += ["--deformable"]
    if frame is not None:
        arguments += ["--frame", frame + 1]   # as people count them; case files count from 0
    run(arguments)
    with open(os.path.join(folder, "result.json"), encoding="utf-8") as file:
        return json.load(file)


def vessels_as_curves(tree, folder, bent=None):
    """A .mrk.json of the vessels: bent as they were in the image where that is there, else as they were given."""
    curves = os.path.join(folder, "vessels.mrk.json")
    run(["convert", bent if bent and os.path.exists(bent) else tree, curves])
    return curves


def camera_from_patient_ras(result):
    """Four rows of four: the pose of a result with both sides RAS, that is with x and y of both turned round."""
    rows = result["pose"]["cameraFromPatient"]
    signs = (-1.0, -1.0, 1.0, 1.0)
    return [[signs[i] * rows[i][k] * signs[k] for k in range(4)] for i in range(4)]


def inverse(rows):
    """Of a rigid motion."""
    turned = [[rows[k][i] for k in range(3)] for i in range(3)]
    back = [-sum(turned[i][k] * rows[k][3] for k in range(3)) for i in range(3)]
    return [turned[i] + [back[i]] for i in range(3)] + [[0.0, 0.0, 0.0, 1.0]]


def write_itk_transform(rows, path):
    """An ITK text file (LPS). Slicer takes such a file as leading from the parent: give the inverse of what nodes
    below it are to be moved by."""
    numbers = [rows[i][k] for i in range(3) for k in range(3)] + [rows[i][3] for i in range(3)]
    with open(path, "w", encoding="utf-8") as file:
        file.write(
            "#Insight Transform File V1.0\n#Transform 0\nTransform: AffineTransform_double_3_3\n"
            f"Parameters: {' '.join(map(repr, numbers))}\nFixedParameters: 0 0 0\n"
        )
