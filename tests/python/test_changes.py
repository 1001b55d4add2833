"""A change either takes effect or raises: none is lost without a word."""

import copy

import numpy as np
import pytest

import angiopose


@pytest.fixture
def session(simulated):
    return copy.copy(simulated.session)


@pytest.fixture
def problem(simulated):
    return angiopose.inputOf(simulated.session)


def test_arrays_that_come_out_are_read_only(session, problem, simulated):
    result = angiopose.evaluatePose(problem, simulated.trueCameraFromPatient)
    cArm = angiopose.CArm(isocentreInPatientMm=[1, 2, 3])
    geometry = angiopose.VolumeGeometry([3, 4, 5], [1, 1, 1])
    tracing = angiopose.VesselTracingOptions(seedsInPatient=[[1, 2, 3]], rootInPatient=[1, 2, 3])
    for array in (
        session.startPose, session.cameraFromPatient, session.tree.points,
        problem.initialCameraFromPatient, problem.lockReference, problem.image,
        simulated.trueCameraFromPatient, result.cameraFromPatient,
        result.uncertainty.covariance, result.uncertainty.rotationDeg, result.uncertainty.centroidInPatient,
        cArm.isocentreInPatientMm, geometry.spacingMm, geometry.direction,
        tracing.seedsInPatient, tracing.rootInPatient,
    ):
        with pytest.raises(ValueError, match="read-only"):
            array += 1.0


def test_lists_that_come_out_are_tuples(session, problem, simulated):
    result = angiopose.evaluatePose(problem, simulated.trueCameraFromPatient)
    for values in (
        problem.excludedBranchIds, problem.auxiliaryBranchIds, session.excludedBranchIds, session.options.locks,
        session.warnings, result.branches, result.warnings, angiopose.VesselReadOptions(labels=[1]).labels,
        session.tree.labels,
    ):
        assert isinstance(values, tuple)


def test_what_a_case_gave_away_cannot_be_set(session):
    for change in (
        lambda: setattr(session.camera, "fx", -1.0),
        lambda: setattr(session.cArm, "rollDeg", 3.0),
        lambda: setattr(session.angiogram.cArm, "rollDeg", 3.0),
        lambda: setattr(session.traceOptions, "sensitivity", 2.0),
        lambda: setattr(session.options, "method", "dynaweight"),
        lambda: session.options.set("maxIterations", 33),
    ):
        with pytest.raises(AttributeError, match="would be lost"):
            change()
    with pytest.raises(TypeError):
        session.options.values["maxIterations"] = "33"


def test_what_is_assigned_takes_effect(session, problem):
    options = copy.copy(session.options)
    session.options = options.set("maxIterations", 33).set("search", True)
    assert session.options.values["maxIterations"] == "33"
    camera = copy.copy(session.camera)
    camera.cx += 10
    session.camera = camera
    assert session.camera.cx == camera.cx
    session.excludedBranchIds = [session.tree.branchIds[0]]
    assert angiopose.inputOf(session).excludedBranchIds == (session.tree.branchIds[0],)
    session.traceOptions = angiopose.TraceOptions(sensitivity=1.5)
    assert session.traceOptions.sensitivity == 1.5

    before = problem.camera.cx
    problem.camera.cx += 10
    assert problem.camera.cx == before + 10
    problem.excludedBranchIds = [3, 4]
    assert problem.excludedBranchIds == (3, 4)
    reading = angiopose.VesselReadOptions()
    reading.tracing.threads = 3
    reading.tracing.seedsInPatient = [[1, 2, 3]]
    assert reading.tracing.threads == 3 and reading.tracing.seedsInPatient.tolist() == [[1, 2, 3]]


def test_a_c_arm_gives_a_plain_image_camera_and_start_pose(simulated):
    known = simulated.session
    run = known.angiogram
    plain = angiopose.Case(known.tree, angiopose.Angiogram(run.frame(run.suggestedFrame), run.polarity))
    with pytest.raises(angiopose.Error):
        plain.camera
    plain.cArm = known.cArm
    assert plain.camera.fx == known.camera.fx < 0
    assert np.array_equal(plain.cameraFromPatient, plain.startPose)
    centred = angiopose.evaluatePose(angiopose.inputOf(plain), plain.startPose).uncertainty.centroidInPatient
    expected = angiopose.cameraFromPatient(known.cArm, centred)
    assert np.allclose(plain.startPose, expected, atol=1e-9)


def test_principal_point_is_an_argument():
    cArm = angiopose.CArm(principalPointUPx=250.0, principalPointVPx=260.0)
    assert (cArm.principalPointUPx, cArm.principalPointVPx) == (250.0, 260.0)


def test_what_things_are_is_seen(session, problem):
    assert "8 branches" in repr(session.tree)
    assert repr(problem.camera).startswith("ProjectionCamera(fx=-")
    assert "Simulated case" in repr(session)
    assert "'angiopose'" in repr(session.options)
