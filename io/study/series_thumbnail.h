#pragma once

#include "core/imaging/image2d.h"
#include "core/support/result.h"
#include "io/series/series.h"
#include "io/support/read_observer.h"

namespace angiopose::io {

/// Returns a thumbnail of a series (0 black to 1 white, longest side at most `sidePx`): the middle slice with a window
/// for vessels, or the middle frame of a run. Reads no more of the files than necessary.
core::Result<core::ImageF> seriesThumbnail(const DicomSeries& series, int sidePx, const ReadObserver& observe = {});

}   // namespace angiopose::io
