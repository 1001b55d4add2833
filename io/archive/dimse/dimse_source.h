#pragma once

#include "io/archive/dimse/link.h"
#include "io/archive/store/series_source.h"

#include <memory>

namespace angiopose::io {

/// Objects by C-GET; where the archive does not offer that, by C-MOVE to a port of ours.
std::unique_ptr<SeriesSource> makeDimseSource(const ArchiveNode& node, const StopQuestion& isStopWished);

}   // namespace angiopose::io
