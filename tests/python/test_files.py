"""Reading, writing, tracing, simulating; NumPy views."""

import copy

import numpy as np
import pytest

import angiopose


def test_tracing_an_image_gives_what_the_command_line_gives(demo, cli, tmp_path):
    cli(demo, "trace-angiogram", "angiogram.dcm", "--output", str(tmp_path / "cli.csv"))
    run = angiopose.readAngiogram(str(demo / "angiogram.dcm"))
    trace = angiopose.traceFrame(run, run.suggestedFrame)
    angiopose.writeCenterline2d(trace.centerline, str(tmp_path / "ours.csv"))
    assert (tmp_path / "ours.csv").read_bytes() == (tmp_path / "cli.csv").read_bytes()
    assert trace.vesselMask.shape == trace.vesselness.shape == (run.height, run.width)


def test_a_path_may_be_a_path(demo, tmp_path):
    session = angiopose.readCase(demo / "case.angiopose")
    assert session.title == angiopose.readCase(str(demo / "case.angiopose")).title
    angiopose.readCase(demo / "tree.vtp", demo / "angiogram.dcm")
    angiopose.writePose(session.startPose, tmp_path / "pose.json")
    assert np.array_equal(angiopose.readPose(tmp_path / "pose.json"), session.startPose)
    angiopose.writeVesselTree(angiopose.readVesselTree(demo / "tree.vtp"), tmp_path / "tree.csv")
    assert len(angiopose.readVessels(tmp_path / "tree.csv").tree) == len(session.tree)
    angiopose.writeAngiogram(angiopose.readAngiogram(demo / "angiogram.dcm"), tmp_path / "run.dcm")
    assert (tmp_path / "run.dcm").exists()


def test_helper_programs_are_found(tmp_path):
    pose = np.array([[0.0, -1.0, 0.0, 1.5], [1.0, 0.0, 0.0, -2.0], [0.0, 0.0, 1.0, 740.1], [0.0, 0.0, 0.0, 1.0]])
    angiopose.writePose(pose, tmp_path / "pose.h5")
    assert np.array_equal(angiopose.readPose(tmp_path / "pose.h5"), pose)
    path = tmp_path / "tree.vtk"
    path.write_text("# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n"
                    "0 0 0 10 0 0 20 0 0\nLINES 1 4\n3 0 1 2\n")
    assert len(angiopose.readVesselTree(path)) == 3
    path.write_text(path.read_text().replace("LINES 1 4", "LINES 1 90"))
    with pytest.raises(angiopose.Error, match="LINES"):
        angiopose.readVesselTree(path)


def tube():
    """A mask (k, j, i) with a tube along k, spacing 1 mm, and its geometry."""
    mask = np.zeros((60, 30, 30), np.uint8)
    mask[4:-4, 10:20, 10:20] = 1
    return mask, angiopose.VolumeGeometry([30, 30, 60], [1, 1, 1])


def test_tracing_a_scan_gives_what_the_command_line_gives(cli, tmp_path):
    mask, geometry = tube()
    scan = angiopose.Volume((mask * 300).astype(np.int16), geometry)
    angiopose.writeVolume(scan, str(tmp_path / "scan.nii.gz"))
    cli(tmp_path, "trace-vessel", "scan.nii.gz", "--output", "cli.csv", "--threshold", "150")
    options = angiopose.VesselTracingOptions(threshold=150)
    vessels = angiopose.readVessels(str(tmp_path / "scan.nii.gz"), angiopose.VesselReadOptions(tracing=options))
    angiopose.writeVesselTree(vessels.tree, str(tmp_path / "ours.csv"))
    assert (tmp_path / "ours.csv").read_bytes() == (tmp_path / "cli.csv").read_bytes()
    assert np.array_equal(angiopose.readVolume(str(tmp_path / "scan.nii.gz")).voxels, scan.voxels)


def test_a_mask_is_traced_and_stopped():
    mask, geometry = tube()
    vessels = angiopose.traceMask(mask, geometry)
    assert len(vessels.tree) > 20
    assert vessels.lumen.shape == mask.shape
    middle = vessels.tree.points[len(vessels.tree) // 2]
    assert abs(middle[0] - 14.5) < 1 and abs(middle[1] - 14.5) < 1
    with pytest.raises(angiopose.Stopped):
        angiopose.traceMask(mask, geometry, observe=lambda progress: angiopose.Verdict.Stop)
    with pytest.raises(ValueError, match="k, j, i"):
        angiopose.traceMask(mask.T, geometry)


def test_numbers_that_would_change_are_refused():
    mask, geometry = tube()
    with pytest.raises(ValueError, match="must be integers"):   # 0.7 would become 0
        angiopose.traceMask(mask * 0.7, geometry)
    with pytest.raises(ValueError, match="too large"):   # 256 would become 0
        angiopose.traceMask(mask.astype(np.int32) * 256, geometry)
    with pytest.raises(ValueError, match="too large"):
        angiopose.Volume(mask.astype(np.int64) * 40000, geometry)
    assert len(angiopose.traceMask(mask > 0, geometry).tree) > 20


def test_a_simulated_case_is_written_and_opens_again(simulated, tmp_path):
    session = copy.copy(simulated.session)
    session.title = "made here"
    angiopose.writeCase(session, str(tmp_path / "made.angiopose"))
    read = angiopose.readCase(str(tmp_path / "made.angiopose"))
    assert read.title == "made here" != simulated.session.title
    assert np.array_equal(read.startPose, session.startPose)
    assert np.array_equal(read.tree.points, session.tree.points)
    both = angiopose.readCase(str(tmp_path / "made.tree.vtp"), str(tmp_path / "made.angiogram.dcm"))
    assert np.array_equal(both.tree.branchIds, session.tree.branchIds)


def test_the_true_pose_of_a_simulated_case_is_that_of_the_command_line(demo):
    ours = angiopose.simulateCase(7)
    assert np.array_equal(ours.trueCameraFromPatient, angiopose.readPose(str(demo / "true-pose.json")))


def test_views_are_shared_read_only_and_outlive_their_owner(simulated):
    run = simulated.session.angiogram
    frame = run.frame(0)
    assert np.shares_memory(frame, simulated.session.angiogram.frame(0))
    assert not frame.flags.writeable and frame.dtype == np.float32
    total = float(frame.sum())
    del run
    assert float(frame.sum()) == total
    points = simulated.session.tree.points
    assert points.shape[1] == 3 and not points.flags.owndata
    with pytest.raises(ValueError):
        points[0, 0] = 1.0


def test_projection_of_points(arrays):
    pixels = angiopose.project(arrays.camera, arrays.initialCameraFromPatient, arrays.tree.points)
    assert pixels.shape == (len(arrays.tree), 2)
    one = angiopose.project(arrays.camera, arrays.initialCameraFromPatient, arrays.tree.points[3])
    assert np.array_equal(one, pixels[3])
    behind = np.linalg.inv(arrays.initialCameraFromPatient)[:3] @ np.array([0, 0, -5, 1])
    assert np.isnan(angiopose.project(arrays.camera, arrays.initialCameraFromPatient, behind)).all()
