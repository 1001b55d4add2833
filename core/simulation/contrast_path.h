#pragma once

#include "core/geometry/projection_camera.h"
#include "core/geometry/rigid_transform.h"
#include "core/imaging/image2d.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// A short segment of opacified lumen.
struct ContrastPoint {
    Eigen::Vector3d pointInPatient;
    double radiusMm = 0.0;
    double opacity = 0.0;   ///< fraction of the injected concentration, 0…1
    double pathMm = 0.0;   ///< path length from the inlet to this point; negative inside the catheter
};

/// Points along one vessel, in order.
using ContrastPath = std::vector<ContrastPoint>;

/// Time course of the contrast bolus, in seconds from the start of the injection.
struct Bolus {
    double speedMmPerS = 150.0;
    double injectionS = 1.6;
    double riseS = 0.4;   ///< blur of the bolus front
    double washoutS = 0.45;   ///< decay time after the injection

    /// Returns the concentration (0…1) at `pathMm` at time `timeS`, including the cardiac pulsation.
    double concentration(double pathMm, double timeS) const;
};

/// Returns the thickness in mm of undiluted contrast agent along each pixel's ray at `timeS` (ALGORITHMS §4.4, tube
/// chords).
ImageF contrastThicknessMm(const std::vector<ContrastPath>& paths, const Bolus& bolus, double timeS,
                           const ProjectionCamera& camera, const RigidTransform& cameraFromPatient);

}   // namespace angiopose::core
