#pragma once

#include "core/imaging/image2d.h"
#include "core/simulation/contrast_path.h"
#include "core/simulation/simulated_case.h"

#include <vector>

namespace angiopose::core {

/// What stands before the detector.
struct DsaScene {
    std::vector<ContrastPath> paths;
    double longestPathMm = 0.0;
    ProjectionCamera camera;
    RigidTransform cameraFromPatient;
};

/// A run as exported: whole numbers 0…4095, vessels dark on mid grey, 0 behind the shutter.
struct DsaRun {
    std::vector<ImageF> frames;
    double frameTimeMs = 0.0;   ///< 0 for a single frame
    int peakFrame = 0;   ///< most contrast medium in the field
    ImageF trueContrast;   ///< of that frame: grey values by which the contrast medium darkens it, free of noise
};

/// Image formation of ALGORITHMS §4.4: Beer–Lambert, scatter, blur, quantum noise, log subtraction of a mask that no
/// longer fits exactly.
DsaRun formDsaFrames(const DsaScene& scene, const DsaOptions& options, const CounterRandom& random);

}   // namespace angiopose::core