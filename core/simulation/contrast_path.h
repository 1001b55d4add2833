#pragma once

#include "core/geometry/projection_camera.h"
#include "core/geometry/rigid_transform.h"
#include "core/imaging/image2d.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// A short piece of lumen that contrast medium reaches.
struct ContrastPoint {
    Eigen::Vector3d pointInPatient;
    double radiusMm = 0.0;
    double opacity = 0.0;   ///< share of the injected concentration, 0…1
    double pathMm = 0.0;   ///< way of the blood from the inlet; negative inside the catheter
};

/// Ordered points of one vessel.
using ContrastPath = std::vector<ContrastPoint>;

/// How the bolus travels: seconds since the injection began.
struct Bolus {
    double speedMmPerS = 150.0;
    double injectionS = 1.6;
    double riseS = 0.4;   ///< the front is this blurred
    double washoutS = 0.45;   ///< decay time after the injection

    /// Concentration (0…1) that has reached `pathMm` at `timeS`, with the heart's beat in it.
    double concentration(double pathMm, double timeS) const;
};

/// Millimetres of undiluted contrast medium along each pixel's ray at `timeS` (ALGORITHMS §4.4, tube chords).
ImageF contrastThicknessMm(const std::vector<ContrastPath>& paths, const Bolus& bolus, double timeS,
                           const ProjectionCamera& camera, const RigidTransform& cameraFromPatient);

}   // namespace angiopose::core