#pragma once

#include "core/simulation/scan_painter.h"
#include "core/support/random.h"
#include "core/vessel/vessel_tree.h"

namespace angiopose::core {

/// Values of the tissues of a trunk in a scan.
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

/// The aorta from its root over the arch to the iliac and femoral arteries (generation 0 and 1), with the branches of
/// the arch and the abdomen; the heart is at the origin, the aortic bifurcation 190 mm below.
VesselTree bodyArteries(CounterRandom& random);

/// The left ventricle and its outflow tract, as a vessel.
VesselTree leftVentricle();

/// Paints everything except the arteries: skin, lungs, spine, heart, liver, kidneys, great veins.
void paintBody(ScanPainter& painter, const TrunkValues& values, CounterRandom& random);

}   // namespace angiopose::core
