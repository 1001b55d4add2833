"""Input that makes no sense is refused, and the words say why."""

import numpy as np
import pytest

import angiopose


def changed(arrays, **fields):
    values = {name: getattr(arrays, name) for name in ("tree", "target", "camera", "initialCameraFromPatient")}
    return angiopose.RegistrationInput(**{**values, **fields})


def idOf(work):
    with pytest.raises(angiopose.Error) as caught:
        work()
    return caught.value.id


@pytest.mark.parametrize("radius", [np.nan, -1.0, np.inf])
def test_a_radius_that_is_none(arrays, radius):
    radii = arrays.tree.radiusMm.copy()
    radii[3] = radius
    tree = angiopose.VesselTree(arrays.tree.points, arrays.tree.branchIds, radii)
    assert idOf(lambda: angiopose.registerVessels(changed(arrays, tree=tree))) == "tree.branch-radius-unusable"


def test_radii_unknown_along_a_whole_branch_are_fine(arrays):
    radii = np.where(arrays.tree.branchIds == arrays.tree.branchIds[0], np.nan, arrays.tree.radiusMm)
    tree = angiopose.VesselTree(arrays.tree.points, arrays.tree.branchIds, radii)
    angiopose.evaluatePose(changed(arrays, tree=tree), arrays.initialCameraFromPatient)


def test_a_forgotten_start_pose(arrays):
    assert idOf(lambda: angiopose.registerVessels(changed(arrays, initialCameraFromPatient=np.eye(4)))) == (
        "input.start-pose-behind-source"
    )


def test_a_tree_in_metres_is_told_of_its_unit(arrays, simulated):
    metres = angiopose.VesselTree(arrays.tree.points / 1000, arrays.tree.branchIds)
    result = angiopose.evaluatePose(changed(arrays, tree=metres), simulated.trueCameraFromPatient)
    texts = " ".join(warning.text for warning in result.warnings)
    assert "Only 100" not in texts and not result.trustworthy


def test_a_camera_of_another_image(simulated):
    session = angiopose.Case(simulated.session.tree, simulated.session.angiogram)
    before = session.camera.width
    camera = angiopose.ProjectionCamera(-3000, 3000, 150, 150, 300, 300)
    assert idOf(lambda: setattr(session, "camera", camera)) == "camera.other-image"
    assert session.camera.width == before


@pytest.mark.parametrize("value", [40.5, "many"])
def test_options_that_are_no_such_number(arrays, value):
    options = angiopose.RegistrationOptions(maxIterations=value)
    assert idOf(lambda: angiopose.registerVessels(arrays, options)) in ("options.needs-whole-number", "options.needs-value")


def test_a_choice_is_told_its_values(arrays):
    options = angiopose.RegistrationOptions(search="perhaps")
    with pytest.raises(angiopose.Error, match="one of off, on, not 'perhaps'"):
        angiopose.registerVessels(arrays, options)


def test_geometry_that_is_no_number(simulated):
    cArm = simulated.session.cArm
    assert idOf(lambda: angiopose.cameraFromPatient(cArm, [np.nan, 0, 0])) == "geometry.isocentre-not-finite"


@pytest.mark.parametrize(
    "options",
    [{"minVesselRadiusPx": 9.0}, {"minVesselRadiusPx": -1.0}, {"maxVesselRadiusPx": np.nan}, {"sensitivity": 0.0}],
)
def test_tracing_of_no_vessel(simulated, options):
    run = simulated.session.angiogram
    assert idOf(lambda: angiopose.traceFrame(run, 0, angiopose.TraceOptions(**options))).startswith("trace.")


@pytest.mark.parametrize(
    "options",
    [{"branchCount": 0}, {"branchCount": -5}, {"missingBranchShare": 2}, {"nonRigidStdMm": np.nan}, {"frameCount": 0}],
)
def test_a_simulation_that_cannot_be(options):
    made = angiopose.SimulationOptions(**options)
    assert idOf(lambda: angiopose.simulateCase(1, made)) == "simulation.out-of-range"


def test_runs_and_cases_of_nothing(simulated):
    run = simulated.session.angiogram
    assert idOf(lambda: angiopose.Angiogram(np.zeros((0, 4, 5)))) == "library.no-frames"
    assert idOf(lambda: angiopose.Case(angiopose.VesselTree([], []), run)) == "tree.no-branches"
    with pytest.raises(ValueError, match="colors"):
        angiopose.Angiogram(np.zeros((64, 48, 3)))
