"""The examples, run as they are."""

import json
import os
import pathlib
import subprocess
import sys

examples = pathlib.Path(os.environ["ANGIOPOSE_ROOT"]) / "resources" / "examples" / "python"


def run(name, folder, *arguments):
    done = subprocess.run(
        [sys.executable, "-B", str(examples / name), *map(str, arguments)], cwd=folder, capture_output=True, text=True
    )
    assert done.returncode in (0, 4), done.stderr
    return done.stdout


def test_register_arrays(tmp_path):
    assert "median 0.0" in run("register_arrays.py", tmp_path)


def test_register_case(demo, cli, tmp_path):
    cli(demo, "register", "case.angiopose", "--output", str(tmp_path / "cli"))
    run("register_case.py", tmp_path, demo / "case.angiopose", "result.json")
    ours = json.loads((tmp_path / "result.json").read_text())
    theirs = json.loads((tmp_path / "cli" / "result.json").read_text())
    for result in (ours, theirs):   # how long, when and for whom
        for key in ("timeMs", "time", "author"):
            result.pop(key, None)
    assert ours == theirs


def test_trace_image(demo, tmp_path):
    assert "points" in run("trace_image.py", tmp_path, demo / "angiogram.dcm", "centreline.csv")
    assert (tmp_path / "centreline.csv").exists()


def test_simulate_and_stop(tmp_path):
    assert "stopped" in run("simulate_and_stop.py", tmp_path)
