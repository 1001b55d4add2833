"""The modules for 3D Slicer with a stand-in for Slicer, and the real angiopose-cli on a simulated case."""

import json
import math
import os
import pathlib
import re
import subprocess
import sys
import unittest
import tempfile
import xml.etree.ElementTree as ElementTree

ROOT = pathlib.Path(os.environ["ANGIOPOSE_ROOT"])
MODULES = ROOT / "resources" / "slicer"
sys.path[:0] = [str(pathlib.Path(__file__).parent), str(MODULES / "AngioPose"), str(MODULES / "AngioPoseRegister")]

import stand_in  # noqa: E402

slicer = stand_in.install()

import AngioPose  # noqa: E402
import AngioPoseRegister  # noqa: E402
from AngioPoseLib import command_line  # noqa: E402


def moved(rows, point):
    return [sum(rows[i][k] * point[k] for k in range(3)) + rows[i][3] for i in range(3)]


def distance(a, b):
    return math.dist(a, b)


def curves_of(path):
    """Points in LPS of a tree file, branch by branch."""
    with tempfile.TemporaryDirectory() as folder:
        curves = os.path.join(folder, "c.mrk.json")
        command_line.run(["convert", path, curves])
        with open(curves, encoding="utf-8") as file:
            return [[p["position"] for p in each["controlPoints"]] for each in json.load(file)["markups"]]


class OnSimulatedCase(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.kept = tempfile.TemporaryDirectory()
        cls.demo = cls.kept.name
        command_line.run(["simulate", "--seed", "7", "--output", cls.demo])
        cls.tree = os.path.join(cls.demo, "tree.vtp")
        cls.angiogram = os.path.join(cls.demo, "angiogram.dcm")
        with open(os.path.join(cls.demo, "true-pose.json"), encoding="utf-8") as file:
            cls.truth = json.load(file)["cameraFromPatient"]
        cls.points = [point for branch in curves_of(cls.tree) for point in branch]

    @classmethod
    def tearDownClass(cls):
        cls.kept.cleanup()

    def largest_error_px(self, rows):
        """Between where pose and truth show the vessels, with a focal length of 2500 px."""
        errors = []
        for point in self.points:
            a, b = moved(rows, point), moved(self.truth, point)
            errors.append(2500 * math.hypot(a[0] / a[2] - b[0] / b[2], a[1] / a[2] - b[1] / b[2]))
        return max(errors)

    def test_model_comes_back_as_transform_and_curves(self):
        vessels = stand_in.Node("vtkMRMLModelNode", "tree", file=self.tree)
        place = self.points[10]
        points = stand_in.Node("vtkMRMLMarkupsFiducialNode", "F", points=[("fork", stand_in.turned(place))])
        result = AngioPose.AngioPoseLogic().register(vessels, self.angiogram, points)
        matrix = result["transformNode"].matrix
        in_lps = [[(-1 if i < 2 else 1) * (-1 if k < 2 else 1) * matrix[i][k] for k in range(4)] for i in range(3)]
        self.assertLess(self.largest_error_px(in_lps), 5.0)
        self.assertEqual(result["transformNode"].attributes["AngioPose.Trustworthy"], str(result["trustworthy"]))
        loaded = [point for node in result["curveNodes"] for point in node.curve]
        self.assertEqual(len(loaded), len(self.points))
        self.assertLess(max(distance(stand_in.turned(a), b) for a, b in zip(loaded, self.points)), 1e-9)
        with open(os.path.join(result["folder"], "result", "result.json"), encoding="utf-8") as file:
            marks = json.load(file)["checkPoints"]
        self.assertEqual(marks[0]["name"], "fork")
        self.assertLess(distance(marks[0]["pointInPatientMm"], place), 1e-9)   # RAS in the scene, LPS in the case

    def test_curves_are_handed_over_in_lps(self):
        branch = max(curves_of(self.tree), key=len)
        node = stand_in.Node("vtkMRMLMarkupsCurveNode", "curve", curve=[stand_in.turned(p) for p in branch])
        with tempfile.TemporaryDirectory() as folder:
            path, kind = AngioPose.AngioPoseLogic.saveVessels(node, folder)
            self.assertEqual(kind, "centerline")
            self.assertLess(max(distance(a, b) for a, b in zip(curves_of(path)[0], branch)), 1e-9)

    def test_what_cannot_be_handed_over_is_said(self):
        logic = AngioPose.AngioPoseLogic()
        under = stand_in.Node("vtkMRMLModelNode", "tree", file=self.tree, parent=object())
        with self.assertRaisesRegex(command_line.RunFailed, "Harden"):
            logic.register(under, self.angiogram)
        with self.assertRaisesRegex(command_line.RunFailed, "label map"):
            logic.register(stand_in.Node("vtkMRMLSegmentationNode", "s"), self.angiogram)
        with self.assertRaisesRegex(command_line.RunFailed, "tree.vtp"):   # the sentence of angiopose-cli, not a traceback
            with tempfile.TemporaryDirectory() as folder:
                command_line.run(["register", self.tree, "--output", folder])

    def test_panel_is_put_together(self):
        widget = AngioPose.AngioPoseWidget()
        widget.setup()
        widget.vessels.currentNode.return_value = None
        widget.onRegister()
        widget.words.setText.assert_called_with("Choose vessels and the file of an angiogram first.")

    def test_command_line_module_writes_the_inverse_for_slicer(self):
        pose, vessels = os.path.join(self.demo, "pose.tfm"), os.path.join(self.demo, "seen.vtp")
        script = MODULES / "AngioPoseRegister" / "AngioPoseRegister.py"
        done = subprocess.run(
            [sys.executable, str(script), self.tree, self.angiogram, pose, vessels], capture_output=True, text=True
        )
        self.assertEqual(done.returncode, 0, done.stderr)
        numbers = [float(n) for n in re.search(r"Parameters: (.*)", pathlib.Path(pose).read_text()).group(1).split()]
        patientFromCamera = [numbers[3 * i : 3 * i + 3] + [numbers[9 + i]] for i in range(3)] + [[0, 0, 0, 1]]
        # Slicer inverts what it reads of a file: its transform to the parent leads to the camera.
        self.assertLess(self.largest_error_px(command_line.inverse(patientFromCamera)), 5.0)
        self.assertEqual(len(curves_of(vessels)), len(curves_of(self.tree)))

    def test_command_line_module_tells_failures(self):
        script = MODULES / "AngioPoseRegister" / "AngioPoseRegister.py"
        done = subprocess.run(
            [sys.executable, str(script), self.tree, self.tree, "pose.tfm", "seen.vtp"], capture_output=True, text=True
        )
        self.assertEqual(done.returncode, 1)
        self.assertNotIn("Traceback", done.stderr)


class Descriptor(unittest.TestCase):
    """By the form of Slicer's execution model: order of what is said of the module, kinds of parameters and what each
    may hold, indices without gaps, flags as the script has them."""

    HEAD = ["category", "title", "description", "version", "documentation-url", "license", "contributor"]
    BY_INDEX = {"file", "transform", "geometry", "image"}

    def setUp(self):
        self.root = ElementTree.parse(MODULES / "AngioPoseRegister" / "AngioPoseRegister.xml").getroot()

    def parameters(self):
        return [each for group in self.root.findall("parameters") for each in group if each.tag not in ("label", "description")]

    def test_has_the_form(self):
        self.assertEqual(self.root.tag, "executable")
        tags = [each.tag for each in self.root]
        self.assertEqual(tags[: len(self.HEAD)], self.HEAD)
        self.assertEqual(set(tags[len(self.HEAD) :]), {"parameters"})
        for each in self.parameters():
            inside = sorted(part.tag for part in each)
            if each.tag in self.BY_INDEX:
                self.assertEqual(inside, ["channel", "description", "index", "label", "name"])
                self.assertIn(each.find("channel").text, ("input", "output"))
            else:
                self.assertIn(each.tag, ("string", "boolean", "double"))
                self.assertEqual(inside, ["default", "description", "label", "longflag", "name"])

    def test_fits_the_script(self):
        indices = [int(each.find("index").text) for each in self.parameters() if each.tag in self.BY_INDEX]
        self.assertEqual(indices, list(range(len(indices))))
        words = [each.find("name").text for each in self.parameters() if each.tag in self.BY_INDEX]
        for each in self.parameters():
            if each.tag not in self.BY_INDEX:
                flag = "--" + each.find("longflag").text
                words += [flag] if each.tag == "boolean" else [flag, each.find("default").text or ""]
        arguments = AngioPoseRegister.parsed(words)
        self.assertEqual(arguments.seenVessels, "seenVessels")
        self.assertEqual(AngioPoseRegister.geometry_of(arguments), {})


if __name__ == "__main__":
    unittest.main()
