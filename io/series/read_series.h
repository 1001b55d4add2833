#pragma once

#include "core/imaging/volume.h"
#include "core/support/result.h"
#include "io/series/series.h"
#include "io/support/read_observer.h"

namespace angiopose::io {

/// Reads the volume of a series, decoding slices one after the other into place. Values are Hounsfield units for CT.
/// Adds to `warnings` what was lost or repaired.
core::Result<core::Volume> readSeries(const DicomSeries& series, const ReadObserver& observe, core::Messages& warnings);

}   // namespace angiopose::io
