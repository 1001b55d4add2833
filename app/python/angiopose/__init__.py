"""Where a 3-D vessel tree lies in a 2-D angiogram.

Two calls suffice. Of files:

    session = angiopose.readCase("case.angiopose")
    result = angiopose.registerCase(session)

Of arrays (points (N, 3) in patient LPS mm, image points (M, 2) in px):

    tree = angiopose.VesselTree(points, branchIds, radiusMm)
    target = angiopose.Centerline2d(imagePoints)
    start = angiopose.cameraFromPatient(cArm, isocentre)
    result = angiopose.registerVessels(angiopose.RegistrationInput(tree, target, camera, start))

Then result.cameraFromPatient is the pose, a matrix (4, 4) from patient mm to camera mm.

Names are exactly those of the C++ library: one documentation covers both. What C++ asks with name() and sets
with setName(value) is an attribute here. Keys of case files are often the same words, those of result.json are not.

What comes out cannot be changed in place where that would be lost: arrays are read-only, lists are tuples, and setting an
attribute of case.camera or case.options raises. Assign the whole, or change a copy.copy() and assign that.

Frames. Patient: LPS, mm. Camera: mm, origin in the X-ray source, Z > 0 towards the detector. Image: px, u right, v down,
(0, 0) is the centre of the first pixel. A standard image is seen from the detector: fx of its camera is below 0. With the
wrong sign the image is mirrored, and a tree of few branches may still fit it.

Long work runs without Python's lock and ends with Ctrl+C. Its last argument `observe` is called with a Progress; it may
return Verdict.Stop, and what it raises comes out of the call.
"""

try:
    import numpy as _numpy  # noqa: F401
except ImportError as missing:
    raise ImportError("angiopose needs NumPy in this Python: install python3-numpy, or use /usr/bin/python3") from missing

from ._angiopose import *  # noqa: F401,F403
from ._angiopose import __version__  # noqa: F401
