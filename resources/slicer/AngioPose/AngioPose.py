"""3D Slicer module: vessels of the scene are registered to an angiogram by angiopose-cli."""

import os
import tempfile

import ctk
import qt
import slicer
from slicer.ScriptedLoadableModule import (
    ScriptedLoadableModule,
    ScriptedLoadableModuleLogic,
    ScriptedLoadableModuleWidget,
)

from AngioPoseLib import command_line

# How a node is handed over: its class, the extension it is saved with, and what it is in a case.
HANDED_OVER = (
    ("vtkMRMLMarkupsCurveNode", ".mrk.json", "centerline"),
    ("vtkMRMLModelNode", ".vtp", "centerline"),
    ("vtkMRMLLabelMapVolumeNode", ".nrrd", "segmentation"),
    ("vtkMRMLScalarVolumeNode", ".nrrd", "volume"),
)


class AngioPose(ScriptedLoadableModule):
    def __init__(self, parent):
        ScriptedLoadableModule.__init__(self, parent)
        self.parent.title = "AngioPose"
        self.parent.categories = ["Registration"]
        self.parent.dependencies = []
        self.parent.contributors = ["AngioPose"]
        self.parent.helpText = (
            "Finds where a vessel tree lies in an X-ray angiogram. Needs angiopose-cli. Research only: not for "
            "clinical use."
        )


class AngioPoseLogic(ScriptedLoadableModuleLogic):
    """Nodes of the scene to a case, and its result back to nodes."""

    def register(self, vessels, angiogramPath, pointsNode=None, method=None, bends=False, geometry=None, folder=None):
        """The result: `trustworthy`, `warnings`, `transformNode`, `curveNodes`, `folder`. Raises
        command_line.RunFailed with a sentence."""
        folder = folder or tempfile.mkdtemp(prefix="angiopose-", dir=slicer.app.temporaryPath)
        vesselPath, kind = self.saveVessels(vessels, folder)
        case = os.path.join(folder, "case.angiopose")
        command_line.write_case(
            case, vesselPath, kind, angiogramPath, geometry, self.pointsOf(pointsNode), vessels.GetName()
        )
        outputs = os.path.join(folder, "result")
        result = command_line.register(case, outputs, method, bends)
        transform = slicer.mrmlScene.AddNewNodeByClass("vtkMRMLLinearTransformNode", vessels.GetName() + " in X-ray")
        slicer.util.updateTransformMatrixFromArray(transform, command_line.camera_from_patient_ras(result))
        transform.SetAttribute("AngioPose.Trustworthy", str(result["trustworthy"]))
        return {
            "trustworthy": result["trustworthy"],
            "warnings": result["warnings"],
            "transformNode": transform,
            "curveNodes": self.loadVessels(vesselPath, kind, outputs, folder),
            "folder": folder,
        }

    @staticmethod
    def saveVessels(node, folder):
        if node.GetParentTransformNode():
            raise command_line.RunFailed("The vessels lie under a transform. Harden it, or take them out of it.")
        for className, extension, kind in HANDED_OVER:
            if node.IsA(className):
                path = os.path.join(folder, "vessels" + extension)
                if not slicer.util.saveNode(node, path):
                    raise command_line.RunFailed(f"“{node.GetName()}” could not be saved.")
                return path, kind
        raise command_line.RunFailed("Choose a model, a curve, a label map or a volume. Export segmentations as label map.")

    @staticmethod
    def pointsOf(node):
        """Names and places of a fiducial node, turned to LPS; under its transform, as they are seen."""
        if not node:
            return []
        points = []
        for number in range(node.GetNumberOfControlPoints()):
            place = [0.0, 0.0, 0.0]
            node.GetNthControlPointPositionWorld(number, place)
            points.append((node.GetNthControlPointLabel(number), (-place[0], -place[1], place[2])))
        return points

    @staticmethod
    def loadVessels(vesselPath, kind, outputs, folder):
        """Curves, where vessels were given as curves or came out bent."""
        bent = os.path.join(outputs, "bent.vtp")
        if kind != "centerline" and not os.path.exists(bent):
            return []
        curves = command_line.vessels_as_curves(vesselPath, folder, bent)
        loaded = slicer.util.loadMarkups(curves)
        return list(loaded) if isinstance(loaded, (list, tuple)) else [loaded]


class AngioPoseWidget(ScriptedLoadableModuleWidget):
    def setup(self):
        ScriptedLoadableModuleWidget.setup(self)
        self.logic = AngioPoseLogic()
        form = qt.QFormLayout()
        box = ctk.ctkCollapsibleButton()
        box.text = "Registration"
        box.setLayout(form)
        self.layout.addWidget(box)
        self.vessels = self.nodeBox([each[0] for each in HANDED_OVER])
        self.points = self.nodeBox(["vtkMRMLMarkupsFiducialNode"])
        self.angiogram = ctk.ctkPathLineEdit()
        self.bends = qt.QCheckBox()
        self.button = qt.QPushButton("Register")
        self.words = qt.QLabel()
        self.words.setWordWrap(True)
        form.addRow("Vessels:", self.vessels)
        form.addRow("Angiogram (file):", self.angiogram)
        form.addRow("Check points:", self.points)
        form.addRow("Deform the vessels:", self.bends)
        form.addRow(self.button)
        form.addRow(self.words)
        self.button.connect("clicked(bool)", self.onRegister)
        self.layout.addStretch(1)

    @staticmethod
    def nodeBox(classNames):
        box = slicer.qMRMLNodeComboBox()
        box.nodeTypes = classNames
        box.noneEnabled = True
        box.addEnabled = False
        box.removeEnabled = False
        box.setMRMLScene(slicer.mrmlScene)
        return box

    def onRegister(self, _checked=False):
        vessels = self.vessels.currentNode()
        if not vessels or not self.angiogram.currentPath:
            self.words.setText("Choose vessels and the file of an angiogram first.")
            return
        try:
            result = self.logic.register(
                vessels, self.angiogram.currentPath, self.points.currentNode(), bends=self.bends.checked
            )
        except command_line.RunFailed as failure:
            self.words.setText(str(failure))
            return
        verdict = "Registered." if result["trustworthy"] else "Registered, but not to be trusted."
        self.words.setText("\n".join([verdict, *result["warnings"], f"Files: {result['folder']}"]))
