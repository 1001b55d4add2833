#pragma once

#include "core/simulation/scan_painter.h"
#include "core/support/random.h"
#include "core/vessel/vessel_tree.h"

namespace angiopose::core {

/// What the tissues of a trunk look like in a scan, in its own values.
struct TrunkValues {
    double fat = -100.0;
    double muscle = 45.0;
    double cortex = 900.0;
    double marrow = 170.0;
    double lung = -850.0;
    double liver = 95.0;
    double kidney = 190.0;
    double vein = 110.0;
    double rightHeart = 250.0;
    double artery = 400.0;
};

/// Aorta from its root over the arch to the iliac and femoral arteries (generation 0 and 1) with the branches of arch
/// and belly; the heart lies about the origin, the fork of the aorta 190 mm below.
VesselTree bodyArteries(CounterRandom& random);

/// The left ventricle and its way out, as a vessel.
VesselTree leftVentricle();

/// Everything but the arteries: skin, lungs, spine, heart, liver, kidneys, great veins.
void paintBody(ScanPainter& painter, const TrunkValues& values, CounterRandom& random);

}   // namespace angiopose::core
