#pragma once

#include "core/simulation/scan_painter.h"
#include "core/support/random.h"

namespace angiopose::core {

/// What a coil at one place receives: full signal there, `1 / strength` half the longest side of the scan away.
struct CoilFallOff {
    Eigen::Vector3d strongestAt = Eigen::Vector3d::Zero();
    double strength = 1.0;
};

void applyFallOff(ScanGrid& grid, const CoilFallOff& coil);

/// As MR stores magnitudes: no negative values, noise of air above 0.
Volume asMagnitudes(const ScanGrid& grid, double noise, const CounterRandom& random);

/// What cone-beam reconstructions of few views show: shading from side to side, streaks across the middle, a bright
/// edge, and nothing outside a round field.
void addConeBeamArtefacts(ScanGrid& grid, double strength, CounterRandom& random);

}   // namespace angiopose::core
