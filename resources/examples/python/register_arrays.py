"""Arrays in, pose out: two vessels and their image points, registered from a start pose that is off."""

import numpy as np

import angiopose

t = np.linspace(0, 1, 90)
trunk = np.column_stack([30 * t, 20 * np.sin(3 * t), 80 * t - 40])  # patient LPS, mm
t = np.linspace(0, 1, 70)
branch = np.column_stack([12 + 45 * t, 18 - 30 * t**2, -8 - 25 * t])
points = np.vstack([trunk, branch])
branchIds = np.repeat([1, 2], [90, 70])
tree = angiopose.VesselTree(points, branchIds, radiusMm=np.where(branchIds == 1, 1.5, 0.9))

cArm = angiopose.CArm(  # as DICOM has it: mm and degrees
    sourceToDetectorMm=1100, sourceToPatientMm=765, columnSpacingMm=0.3, rowSpacingMm=0.3,
    primaryAngleDeg=-30, secondaryAngleDeg=20,
)
camera = angiopose.cameraFromCArm(cArm, 512, 512)
truth = angiopose.cameraFromPatient(cArm, [10, 0, 0])
target = angiopose.Centerline2d(angiopose.project(camera, truth, points), branchIds)

cArm.primaryAngleDeg = -26  # the header is 4 degrees off, the isocentre some mm
start = angiopose.cameraFromPatient(cArm, [4, 9, -6])

result = angiopose.registerVessels(angiopose.RegistrationInput(tree, target, camera, start))
print(result.cameraFromPatient)
print(f"median {result.metrics.medianPx:.3f} px, depth ± {result.uncertainty.depthMm:.1f} mm")
centre = np.append(result.uncertainty.centroidInPatient, 1)  # far from it a small turn is a large shift
print(f"off by {np.linalg.norm((result.cameraFromPatient - truth) @ centre):.2f} mm at the centroid")
