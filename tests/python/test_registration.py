"""Registration and evaluation: the same bits as the command line, Stop, exceptions, errors."""

import json
import threading
import time

import numpy as np
import pytest

import angiopose


def test_a_case_gives_what_the_command_line_gives(demo, cli, tmp_path):
    cli(demo, "register", "case.angiopose", "--output", str(tmp_path / "cli"))
    theirs = json.loads((tmp_path / "cli" / "result.json").read_text())

    session = angiopose.readCase(str(demo / "case.angiopose"))
    found = angiopose.registerCase(session)
    angiopose.writeResult(session, str(tmp_path / "result.json"))
    ours = json.loads((tmp_path / "result.json").read_text())
    for result in (theirs, ours):   # how long, when and for whom
        for key in ("timeMs", "time", "author"):
            result.pop(key, None)

    assert ours == theirs
    assert found.cameraFromPatient.tolist() == theirs["pose"]["cameraFromPatient"]
    assert found.metrics.medianPx == theirs["metrics"]["medianProjectionDistancePx"]
    assert found.uncertainty.covariance.tolist() == theirs["uncertainty"]["covariance"]
    assert [warning.text for warning in found.warnings] == [
        each if isinstance(each, str) else each["text"] for each in theirs["warnings"]
    ]


def test_options_reach_the_solver_as_from_the_command_line(demo, cli, tmp_path):
    cli(demo, "register", "case.angiopose", "--method", "dynaweight", "--set", "maxIterations=12", "--output", str(tmp_path))
    theirs = json.loads((tmp_path / "result.json").read_text())
    arrays = angiopose.inputOf(angiopose.readCase(str(demo / "case.angiopose")))
    ours = angiopose.registerVessels(arrays, angiopose.RegistrationOptions("dynaweight", maxIterations=12))
    assert ours.cameraFromPatient.tolist() == theirs["pose"]["cameraFromPatient"]
    assert ours.method == "dynaweight"


def test_bent_vessels_are_those_of_the_command_line(demo, cli, tmp_path):
    cli(demo, "register", "case.angiopose", "--deformable", "--output", str(tmp_path))
    theirs = json.loads((tmp_path / "result.json").read_text())["deformable"]
    session = angiopose.readCase(str(demo / "case.angiopose"))
    options = session.options
    session.options = angiopose.RegistrationOptions(options.method, **{**options.values, "deformable": "always"})
    bent = angiopose.registerCase(session).bent

    assert bent.verdict.name.lower() == theirs["verdict"]
    assert bent.logEvidenceGain == theirs["logEvidenceGain"]
    assert bent.viewPoses[0].tolist() == theirs["cameraFromPatient"]
    assert [message.text for message in bent.messages] == theirs["warnings"]
    assert np.array_equal(bent.tree.points, angiopose.readVesselTree(tmp_path / "bent.vtp").points)
    assert np.allclose(bent.tree.points - bent.displacementMm, angiopose.inputOf(session).tree.points, atol=1e-9)
    assert bent.covarianceMm2.shape == (len(bent.tree), 3, 3)
    with pytest.raises(ValueError):
        bent.displacementMm[0] = 0.0


def test_arrays_of_ones_own_give_the_same_bits(arrays):
    tree = angiopose.VesselTree(arrays.tree.points.copy(), list(arrays.tree.branchIds), arrays.tree.radiusMm)
    target = angiopose.Centerline2d(arrays.target.points, arrays.target.curveIds, arrays.target.radiusPx)
    rebuilt = angiopose.RegistrationInput(
        tree, target, arrays.camera, arrays.initialCameraFromPatient, image=arrays.image, lockReference=arrays.lockReference
    )
    one, other = angiopose.registerVessels(arrays), angiopose.registerVessels(rebuilt)
    assert np.array_equal(one.cameraFromPatient, other.cameraFromPatient)
    assert np.array_equal(one.uncertainty.covariance, other.uncertainty.covariance)


def test_the_true_pose_is_judged_better_than_the_start(arrays, simulated):
    truth = angiopose.evaluatePose(arrays, simulated.trueCameraFromPatient)
    start = angiopose.evaluatePose(arrays, arrays.initialCameraFromPatient)
    assert truth.metrics.medianPx < 1.5 < start.metrics.medianPx
    assert truth.branches[0].pointCount > 0


def test_stop_keeps_the_best_pose(arrays):
    seen = []

    def observe(progress):
        seen.append((progress.stage, progress.fraction, progress.cameraFromPatient))
        return angiopose.Verdict.Stop if len(seen) == 2 else None

    result = angiopose.registerVessels(arrays, observe=observe)
    assert result.stopReason == angiopose.StopReason.StoppedByUser
    assert len(seen) == 2 and seen[0][1] <= seen[1][1] <= 1.0
    assert seen[0][2].shape == (4, 4)


def test_what_the_observer_raises_comes_out(arrays):
    class Mine(Exception):
        pass

    def observe(progress):
        raise Mine(progress.stage)

    with pytest.raises(Mine):
        angiopose.registerVessels(arrays, observe=observe)
    for answer in ("stop", False, 1):
        with pytest.raises(TypeError, match=f"Verdict or None, not {answer!r}"):
            angiopose.registerVessels(arrays, observe=lambda progress: answer)


def test_other_threads_run_meanwhile(arrays):
    stamps, isDone = [], threading.Event()

    def stampsDuringARun():
        before = time.monotonic()
        angiopose.registerVessels(arrays)
        after = time.monotonic()
        return sum(before < stamp < after for stamp in list(stamps))

    def work():
        while not isDone.is_set():
            stamps.append(time.monotonic())
            time.sleep(0.001)

    thread = threading.Thread(target=work)
    thread.start()
    most = max(stampsDuringARun() for _ in range(30))   # other programs may hold up one run or another
    isDone.set()
    thread.join()
    assert most > 2   # with the lock held: none, or one at either end


def test_errors_say_what_is_wrong(arrays):
    with pytest.raises(angiopose.Error, match="maxIteration'. Did you mean 'maxIterations'") as caught:
        angiopose.registerVessels(arrays, angiopose.RegistrationOptions(maxIteration=5))
    assert caught.value.id == "library.no-option"
    with pytest.raises(angiopose.Error, match="no-such-method"):
        angiopose.registerVessels(arrays, angiopose.RegistrationOptions("no-such-method"))
    with pytest.raises(ValueError, match=r"\(N, 3\)"):
        angiopose.VesselTree(np.zeros((4, 2)), [1, 1, 1, 1])
    with pytest.raises(ValueError, match="branchIds has 3 rows, but there are 4 points"):
        angiopose.VesselTree(np.zeros((4, 3)), [1, 1, 1])
    with pytest.raises(ValueError, match="radiusMm has 5 rows"):
        angiopose.VesselTree(np.zeros((4, 3)), [1, 1, 1, 1], np.ones(5))
    with pytest.raises(ValueError, match="curveIds has 3 rows"):
        angiopose.Centerline2d(np.zeros((4, 2)), [1, 1, 1])
    nothing = angiopose.RegistrationInput(angiopose.VesselTree([], []), arrays.target, arrays.camera, np.eye(4))
    with pytest.raises(angiopose.Error, match="no branches"):
        angiopose.registerVessels(nothing)
    assert issubclass(angiopose.Stopped, angiopose.Error) and issubclass(angiopose.Error, RuntimeError)


def test_every_method_has_options_with_defaults():
    methods = angiopose.methods()
    assert methods[0].id == "angiopose" and len(methods) > 5
    option = next(option for option in methods[0].options if option.key == "maxIterations")
    assert option.min <= float(option.defaultValue) <= option.max
