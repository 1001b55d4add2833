#pragma once

#include "core/case/view.h"
#include "core/geometry/image_measurement.h"
#include "core/support/result.h"
#include "core/vessel/vessel_tree.h"

namespace angiopose::core {

/// What a pixel of an image is where something is measured.
struct ImageScale {
    MeasurementPlane plane = MeasurementPlane::Pixels;
    Eigen::Vector2d unitsPerPx = Eigen::Vector2d::Ones();   ///< along u and v: mm, or px in the plane Pixels
    double depthMm = 0.0;   ///< at the vessels: their centroid from the source, along its ray to the detector's middle
    Origin origin = Origin::Missing;   ///< the least certain one of the values it follows from

    bool isInMm() const { return plane != MeasurementPlane::Pixels; }
};

/// A view with the vessels as they are shown in it: at its own pose, or at one that is looked at for a while.
struct MeasuredView {
    MeasuredView(const View& view, const VesselTree* tree)   ///< `tree` may be null
        : view(view), tree(tree), cameraFromPatient(view.cameraFromPatient)
    {
    }
    MeasuredView(const View& view, const VesselTree* tree, const RigidTransform& cameraFromPatient)
        : view(view), tree(tree), cameraFromPatient(cameraFromPatient)
    {
    }
    /// What found the pose; null where nothing did.
    const RegistrationResult* result() const;

    const View& view;
    const VesselTree* tree;
    RigidTransform cameraFromPatient;
};

/// The scale at the vessels (depth of the tree's centroid at the pose), at the detector (its pixel spacing), as typed
/// for the image, or none.
/// Fails saying what is missing and how to supply it.
Result<ImageScale> imageScaleOf(const MeasuredView& seen, MeasurementPlane plane);

/// The first plane that the view has a scale for: at the vessels, as typed, at the detector, else pixels.
MeasurementPlane bestPlaneOf(const MeasuredView& seen);

}   // namespace angiopose::core
