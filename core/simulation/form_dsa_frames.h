#pragma once

#include "core/imaging/image2d.h"
#include "core/simulation/contrast_path.h"
#include "core/simulation/simulated_case.h"

#include <vector>

namespace angiopose::core {

/// Contrast agent in the vessels and the camera that acquires it.
struct DsaScene {
    std::vector<ContrastPath> paths;
    double maxPathMm = 0.0;
    ProjectionCamera camera;
    RigidTransform cameraFromPatient;
};

/// A run with gray values as exported: integers 0…4095, vessels dark on medium gray, 0 behind the shutter.
struct DsaRun {
    std::vector<ImageF> frames;
    double frameTimeMs = 0.0;   ///< 0 for a single frame
    int peakFrame = 0;   ///< frame with the most contrast agent in the field of view
    ImageF trueContrast;   ///< noise-free decrease of the gray values in that frame due to the contrast agent
};

/// Simulates image formation as in ALGORITHMS §4.4: Beer–Lambert, scatter, blur, quantum noise, and logarithmic
/// subtraction of a mask that no longer matches exactly.
DsaRun formDsaFrames(const DsaScene& scene, const DsaOptions& options, const CounterRandom& random);

}   // namespace angiopose::core
