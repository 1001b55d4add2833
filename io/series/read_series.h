#pragma once

#include "core/imaging/volume.h"
#include "core/support/result.h"
#include "io/series/series.h"
#include "io/support/read_observer.h"

namespace angiopose::io {

/// Reads the volume of a series, decoding one slice after the other. Values are Hounsfield units for CT. Adds warnings
/// about lost and repaired data.
core::Result<core::Volume> readSeries(const DicomSeries& series, const ReadObserver& observe, core::Messages& warnings);

}   // namespace angiopose::io
