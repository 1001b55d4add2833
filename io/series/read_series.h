#pragma once

#include "core/imaging/volume.h"
#include "core/support/result.h"
#include "io/series/series.h"
#include "io/support/read_observer.h"

namespace angiopose::io {

/// The volume of a series, slices decoded one after the other into place. Values are Hounsfield units for CT.
/// What was lost or mended is added to `warnings`.
core::Result<core::Volume> readSeries(const DicomSeries& series, const ReadObserver& observe, core::Messages& warnings);

}   // namespace angiopose::io
