#pragma once

#include "core/simulation/scan_painter.h"
#include "core/support/random.h"
#include "core/vessel/vessel_tree.h"

namespace angiopose::core {

/// Values of the tissues of a head in a scan.
struct HeadValues {
    double scalp = 45.0;   ///< including the neck muscles
    double skull = 900.0;
    double marrow = 200.0;   ///< marrow of the spine
    double brain = 38.0;
    double petrous = 1100.0;   ///< bone around the carotid canal
    double clivus = 600.0;
};

/// The carotid and vertebral arteries from the neck on (generation 0, with the basilar artery), the circle of Willis
/// with its loop and the cerebral arteries. The origin is the center of the head.
VesselTree headArteries(CounterRandom& random);

/// The sagittal sinus below the vault, and one sinus to each side from its end.
VesselTree headSinuses(CounterRandom& random);

/// Paints skin, skull, brain and the cervical spine.
void paintHead(ScanPainter& painter, const HeadValues& values);

}   // namespace angiopose::core
