#pragma once

#include "core/case/view.h"
#include "core/geometry/image_measurement.h"
#include "core/support/result.h"
#include "core/vessel/vessel_tree.h"

namespace angiopose::core {

/// Size of an image pixel in the plane of a measurement.
struct ImageScale {
    MeasurementPlane plane = MeasurementPlane::Pixels;
    Eigen::Vector2d unitsPerPx = Eigen::Vector2d::Ones();   ///< along u and v; in mm, or in px if the plane is `Pixels`
    double depthMm = 0.0;   ///< at the vessels: depth of their centroid along the ray to the detector's center
    Origin origin = Origin::Missing;   ///< least certain origin of the values used

    bool isInMm() const { return plane != MeasurementPlane::Pixels; }
};

/// A view with the displayed vessels, at the view's own pose or at a pose displayed temporarily.
struct MeasurementContext {
    MeasurementContext(const View& view, const VesselTree* tree)   ///< `tree` may be null
        : view(view), tree(tree), cameraFromPatient(view.cameraFromPatient)
    {
    }
    MeasurementContext(const View& view, const VesselTree* tree, const RigidTransform& cameraFromPatient)
        : view(view), tree(tree), cameraFromPatient(cameraFromPatient)
    {
    }
    /// Returns the registration result that belongs to the pose; null if there is none.
    const RegistrationResult* result() const;

    const View& view;
    const VesselTree* tree;
    RigidTransform cameraFromPatient;
};

/// Returns the scale at the vessels (depth of the tree's centroid under the pose), at the detector (its pixel spacing),
/// as entered for the image, or none. The error names the missing value and states how to supply it.
Result<ImageScale> imageScaleOf(const MeasurementContext& context, MeasurementPlane plane);

/// Returns the preferred plane among those for which the view has a scale: the vessels, then the entered pixel size,
/// then the detector, otherwise pixels.
MeasurementPlane preferredPlane(const MeasurementContext& context);

}   // namespace angiopose::core
