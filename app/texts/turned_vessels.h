#pragma once

#include "app/texts/bent_vessels.h"
#include "core/case/case.h"

namespace angiopose::app {

/// The vessels by themselves before a dark ground, as somebody sees them who stands in front of the patient: a view of
/// its own in place of the shown one, which says nothing of image and pose. `shape` where bent ones are known.
core::Case vesselsAlone(const core::Case& theCase, VesselShape shape);

/// The same after the vessels turned about the patient's long axis through their middle.
core::Case turnedBy(core::Case alone, double degrees);

}   // namespace angiopose::app
