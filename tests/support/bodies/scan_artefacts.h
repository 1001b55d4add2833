#pragma once

#include "core/simulation/scan_painter.h"
#include "core/support/random.h"

namespace angiopose::core {

/// Sensitivity of a coil at one position: full signal there, `1 / strength` at a distance of half the longest side of
/// the scan.
struct CoilFallOff {
    Eigen::Vector3d strongestAt = Eigen::Vector3d::Zero();
    double strength = 1.0;
};

void applyFallOff(ScanGrid& grid, const CoilFallOff& coil);

/// Magnitudes as stored by MR: no negative values, and the noise of air is above 0.
Volume asMagnitudes(const ScanGrid& grid, double noise, const CounterRandom& random);

/// Adds the artifacts of cone-beam reconstructions from few views: shading from side to side, streaks across the
/// middle, a bright edge, and nothing outside a round field.
void addConeBeamArtefacts(ScanGrid& grid, double strength, CounterRandom& random);

}   // namespace angiopose::core
