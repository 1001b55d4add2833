"""Where a 3-D vessel tree lies in a 2-D angiogram.

Two calls suffice. Of files:

    theCase = angiopose.readCase("case.angiopose")
    result = angiopose.registerCase(theCase)

Of arrays (points (N, 3) in patient LPS mm, image points (M, 2) in px):

    tree = angiopose.VesselTree(points, branchIds, radiusMm)
    target = angiopose.Centerline2d(imagePoints)
    start = angiopose.cameraFromPatient(cArm, isocentre)
    result = angiopose.registerVessels(angiopose.RegistrationInput(tree, target, camera, start))

Then result.cameraFromPatient is the pose, a matrix (4, 4) from patient mm to camera mm.

Names are those of the C++ library, letter for letter: one documentation tells of both, and the keys of case files, of
result.json and of this module are the same words. What C++ asks with name() and sets with setName(value) is an attribute
here.

Frames. Patient: LPS, mm. Camera: mm, origin in the X-ray source, Z > 0 towards the detector. Image: px, u right, v down,
(0, 0) is the centre of the first pixel.

Long work runs without Python's lock and ends with Ctrl+C. Its last argument `observe` is called with a Progress; it may
return Verdict.Stop, and what it raises comes out of the call.
"""

from ._angiopose import *  # noqa: F401,F403
from ._angiopose import __version__  # noqa: F401
