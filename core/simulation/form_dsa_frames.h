#pragma once

#include "core/imaging/image2d.h"
#include "core/simulation/contrast_path.h"
#include "core/simulation/simulated_case.h"

#include <vector>

namespace angiopose::core {

/// Objects in front of the detector.
struct DsaScene {
    std::vector<ContrastPath> paths;
    double longestPathMm = 0.0;
    ProjectionCamera camera;
    RigidTransform cameraFromPatient;
};

/// A run as exported: integers 0…4095, vessels dark on medium gray, 0 behind the shutter.
struct DsaRun {
    std::vector<ImageF> frames;
    double frameTimeMs = 0.0;   ///< 0 for a single frame
    int peakFrame = 0;   ///< frame with the most contrast agent in the field
    ImageF trueContrast;   ///< noise-free gray-value decrease by the contrast agent in that frame
};

/// Image formation of ALGORITHMS §4.4: Beer–Lambert, scatter, blur, quantum noise, logarithmic subtraction of a mask
/// that no longer matches exactly.
DsaRun formDsaFrames(const DsaScene& scene, const DsaOptions& options, const CounterRandom& random);

}   // namespace angiopose::core