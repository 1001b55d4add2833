#pragma once

#include "core/simulation/scan_painter.h"
#include "core/support/random.h"
#include "core/vessel/vessel_tree.h"

namespace angiopose::core {

/// What the tissues of a head look like in a scan, in its own values.
struct HeadValues {
    double scalp = 45.0;   ///< and the neck's muscles
    double skull = 900.0;
    double marrow = 200.0;   ///< of the spine
    double brain = 38.0;
    double petrous = 1100.0;   ///< bone around the carotid canal
    double clivus = 600.0;
};

/// Carotid and vertebral arteries from the neck on (generation 0, with the basilar), the circle of Willis with its
/// loop, the cerebral arteries. The middle of the head is the origin.
VesselTree headArteries(CounterRandom& random);

/// The sagittal sinus below the vault, and from its end one sinus to each side.
VesselTree headSinuses(CounterRandom& random);

/// Skin, skull, brain, and the spine of the neck.
void paintHead(ScanPainter& painter, const HeadValues& values);

}   // namespace angiopose::core
