"""What the modules use of 3D Slicer, as it behaves: nodes keep RAS, files are written and read in LPS, a matrix given to
a transform node leads to its parent. Widgets take anything."""

import json
import shutil
import sys
import tempfile
import types
from unittest import mock


class Node:
    def __init__(self, className, name, **contents):
        self.className, self.name = className, name
        self.attributes, self.matrix, self.parent = {}, None, None
        self.__dict__.update(contents)

    def IsA(self, className):
        return self.className == className

    def GetName(self):
        return self.name

    def GetParentTransformNode(self):
        return self.parent

    def SetAttribute(self, key, value):
        self.attributes[key] = value

    def GetNumberOfControlPoints(self):
        return len(self.points)

    def GetNthControlPointLabel(self, number):
        return self.points[number][0]

    def GetNthControlPointPositionWorld(self, number, place):
        place[:] = self.points[number][1]


def turned(point):
    return [-point[0], -point[1], point[2]]


class Scene:
    def __init__(self):
        self.nodes = []

    def AddNewNodeByClass(self, className, name):
        self.nodes.append(Node(className, name))
        return self.nodes[-1]


def saveNode(node, path):
    """A model keeps the file it came from; curves are written from their RAS points as LPS."""
    if node.className == "vtkMRMLModelNode":
        shutil.copyfile(node.file, path)
        return True
    markup = {
        "type": "Curve",
        "coordinateSystem": "LPS",
        "controlPoints": [{"id": "1", "position": turned(point), "positionStatus": "defined"} for point in node.curve],
    }
    with open(path, "w", encoding="utf-8") as file:
        json.dump({"markups": [markup]}, file)
    return True


def loadMarkups(path):
    with open(path, encoding="utf-8") as file:
        markups = json.load(file)["markups"]
    assert all(markup["coordinateSystem"] == "LPS" for markup in markups)
    return [
        Node("vtkMRMLMarkupsCurveNode", each["name"], curve=[turned(p["position"]) for p in each["controlPoints"]])
        for each in markups
    ]


def updateTransformMatrixFromArray(node, matrix):
    node.matrix = matrix


class Base:
    def __init__(self, parent=None):
        self.parent = parent or mock.MagicMock()
        self.layout = mock.MagicMock()

    def setup(self):
        pass


def install():
    """Puts the stand-ins where `import slicer`, `qt` and `ctk` find them."""
    slicer = types.ModuleType("slicer")
    slicer.mrmlScene = Scene()
    slicer.app = types.SimpleNamespace(temporaryPath=tempfile.gettempdir())
    slicer.util = types.SimpleNamespace(
        saveNode=saveNode, loadMarkups=loadMarkups, updateTransformMatrixFromArray=updateTransformMatrixFromArray
    )
    slicer.qMRMLNodeComboBox = mock.MagicMock
    scripted = types.ModuleType("slicer.ScriptedLoadableModule")
    for name in ("ScriptedLoadableModule", "ScriptedLoadableModuleLogic", "ScriptedLoadableModuleWidget"):
        setattr(scripted, name, type(name, (Base,), {}))
    sys.modules.update(
        {"slicer": slicer, "slicer.ScriptedLoadableModule": scripted, "qt": mock.MagicMock(), "ctk": mock.MagicMock()}
    )
    return slicer
